import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { shortFloat } from "../../../formats/numbers";
import { type GrammarSource, textOf, withText } from "../../../grammar_editor/source";
import { ControlElement } from "../../../ui/control_element";
import type { EditorContext } from "../../../ui/editor_context";
import { HeldKey } from "../../../ui/held_key";
import { sliderRow } from "../../../ui/slider_row";
import { readTyped } from "../../../ui/typed";
import type { FlowerPlant } from "../flower_plant";
import { text as message } from "../messages.generated";
import type { FlowerSpecimen } from "../specimen";
import { rangeFor, statedRange, type TokenRange, within } from "./number_range";
import { describeNumber, FIELDS } from "./number_words";
import { footOf, organOf, placeOfVolume, titleOfVolume } from "./organ";
import { source } from "./text";
import { type NumberGroup, type NumberToken, numberGroupsOf } from "./token_edits";

/** Panel of the chosen volume: its numbers, and sliders for the numbers in the text that define it. */
export class VolumePanel extends ControlElement<EditorContext<FlowerSpecimen, FlowerPlant>> {
	static override properties = {
		...ControlElement.properties,
		chosenIn: { attribute: false },
		choose: { attribute: false },
	};
	/** Returns the chosen volume of the current flower; a stored number might belong to an earlier one. */
	declare chosenIn: (context: EditorContext<FlowerSpecimen, FlowerPlant>) => number | undefined;
	declare choose: (volume: number | undefined) => void;

	readonly #held = new HeldKey(() => this.context.settle());
	/** The gesture that a slider began; the slider may disappear before it ends, with the volume. */
	#gesture: string | undefined;
	/** Slider ranges, stable during a drag. */
	readonly #ranges = new Map<string, TokenRange>();

	/** Returns the values whose change redraws the panel: the choice, the plant or the text. */
	protected override shows(): readonly unknown[] {
		const { grown } = this.context.state;
		return [this.chosenIn(this.context), grown, this.#text()];
	}

	/** Renders the number of the chosen volume, and its values. */
	protected override draw(context: EditorContext<FlowerSpecimen, FlowerPlant>): unknown {
		const { grown } = context.state;
		const count = grown?.volumes.order.length ?? 0;
		const chosen = this.chosenIn(context);
		return html`<div class="control">
				<label for=${this.idOf("volume")}>${message("volume")}</label>
				<input id=${this.idOf("volume")} class="volume-number" type="number" min="1" max=${count} .value=${live(chosen === undefined ? "" : String(chosen + 1))}
					@change=${({ target }: Event) => this.#choose((target as HTMLInputElement).value, count)}>
			</div>
			<div aria-live="polite">${
				grown && chosen !== undefined ? this.#name(grown, chosen) : html`<p>${message("nothing_selected")}</p>`
			}</div>
			${grown && chosen !== undefined ? [this.#drawValues(grown, chosen), this.#drawNumbers(grown, chosen)] : nothing}`;
	}

	/**
	 * Chooses the volume of a typed number, counted from 1; any other text chooses none.
	 * @param count number of volumes
	 */
	#choose(typed: string, count: number): void {
		const number = Math.round(readTyped(typed));
		this.choose(number >= 1 && number <= count ? number - 1 : undefined);
		this.requestUpdate();
	}

	/** Draws the title and the place of a volume. */
	#name(grown: FlowerPlant, chosen: number): unknown {
		const { volumes } = grown;
		const place = placeOfVolume(volumes, chosen, organOf(volumes, chosen), this.#text() ?? "");
		return html`<h3 class="volume-name">${titleOfVolume(grown, chosen)}</h3><p class="volume-place">${place}</p>`;
	}

	/** Draws the nine numbers of a volume as evaluated, rounded to four digits. */
	#drawValues({ volumes }: FlowerPlant, chosen: number): unknown {
		const own = volumes.values.subarray(9 * chosen, 9 * chosen + 9);
		return html`<dl class="volume-values">
			${FIELDS.map(([name, key, unit], i) => html`<div><dt><abbr title=${message(key)}>${name}</abbr></dt><dd>${shortFloat(Number(own[i].toPrecision(4)))}${unit && html` <small>${unit}</small>`}</dd></div>`)}
		</dl>`;
	}

	/**
	 * Draws sliders for the numbers in the text that define a volume, in groups: of its definition, its production, its
	 * module's call, and variables.
	 */
	#drawNumbers({ volumes }: FlowerPlant, chosen: number): unknown {
		const text = this.#text();
		if (text === undefined) return nothing;
		const label = volumes.label[chosen];
		const groups = numberGroupsOf(text, {
			label: volumes.labels[label],
			module: volumes.module[label],
			line: volumes.line[chosen],
			call: volumes.call[chosen],
			face: volumes.face[chosen],
			moduleFace: volumes.face[footOf(volumes, chosen).foot],
		});
		const same = `${volumes.labels[label]} ${volumes.module[label]} ${volumes.line[chosen]}`;
		return html`${repeat(
			groups,
			({ title }) => `${same} ${title}`,
			(group) => this.#group(group),
		)}
		<div class="actions"><button class="button" type="button" @click=${() => this.choose(undefined)}>${message("deselect")}</button></div>`;
	}

	/** Draws a group of sliders under its title. */
	#group({ title, tokens }: NumberGroup): unknown {
		return html`<fieldset class="volume-numbers"><legend>${title}</legend>${tokens.map((token, i) => this.#slider(token, title, i))}</fieldset>`;
	}

	/** Draws the slider of a number. Its range stays as long as the number is within it. */
	#slider(token: NumberToken, title: string, index: number): unknown {
		const { name, text } = token;
		const key = `${title} ${index} ${name}`;
		const defaultRange = token.range ? statedRange(token.range) : rangeFor(name, Number(text));
		const range = within(this.#ranges.get(key), Number(text)) ?? defaultRange;
		this.#ranges.set(key, range);
		const { min, max, step } = range;
		const description = describeNumber(this.#text() ?? "", name);
		return html`<div class="control">${sliderRow({
			id: this.idOf(key),
			label: description ? html`<span title=${description}>${name}</span>` : name,
			name: message("slider_name", { name, title }),
			typedName: message("typed", { name: message("slider_name", { name, title }) }),
			min,
			max,
			step,
			value: Number(text),
			text,
			help: helpText(description, message("range", { least: min, most: max })),
			held: this.#held,
			slide: (value) => this.#edit(token, range.written(value), key),
			type: (typed) => {
				if (!Number.isFinite(typed)) return text;
				this.context.set(this.#replaceNumber(token, String(typed)));
				return String(typed);
			},
		})}</div>`;
	}

	/** Ends a drag that is in progress. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#settle();
	}

	/** Ends a drag whose volume is no longer chosen. */
	protected override updated(): void {
		if (this.chosenIn(this.context) === undefined) this.#settle();
	}

	/** Applies a step of a drag to a number of the text. */
	#edit(token: NumberToken, written: string, key: string): void {
		if (written === token.text) return;
		this.#gesture = `token ${key}`;
		this.context.edit({ ...this.#replaceNumber(token, written), run: this.#held.run }, this.#gesture);
	}

	/** Ends the gesture that a slider began, if there is one. */
	#settle(): void {
		if (this.#gesture !== undefined) this.context.settle(this.#gesture);
		this.#gesture = undefined;
	}

	/** Returns the change that replaces a number in the text. */
	#replaceNumber({ from, to }: NumberToken, written: string) {
		const text = this.#text() ?? "";
		return withText(
			source as unknown as GrammarSource,
			this.context.state.specimen,
			text.slice(0, from) + written + text.slice(to),
		);
	}

	/** Returns the flower's text; undefined while it loads, after which the panel is drawn again. */
	#text(): string | undefined {
		return textOf(source as unknown as GrammarSource, this.context.state.specimen, () => this.requestUpdate());
	}
}

/** Joins a number's description and its range to the help of its slider. */
const helpText = (description: string, range: string): string =>
	description ? message("help_and_range", { help: `${description}.`, range }) : range;

customElements.define("panicle-volume", VolumePanel);
