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

	protected override shows(): readonly unknown[] {
		const { grown } = this.context.state;
		return [this.chosenIn(this.context), grown, this.#text()];
	}

	protected override draw(context: EditorContext<FlowerSpecimen, FlowerPlant>): unknown {
		const { grown } = context.state;
		const count = grown?.volumes.order.length ?? 0;
		const chosen = this.chosenIn(context);
		return html`<div class="control">
				<label for=${this.idOf("volume")}>Volume</label>
				<input id=${this.idOf("volume")} class="volume-number" type="number" min="1" max=${count} .value=${live(chosen === undefined ? "" : String(chosen + 1))}
					@change=${({ target }: Event) => this.#choose((target as HTMLInputElement).value, count)}>
			</div>
			<div aria-live="polite">${
				grown && chosen !== undefined ? this.#name(grown, chosen) : html`<p>None is chosen.</p>`
			}</div>
			${grown && chosen !== undefined ? [this.#drawValues(grown, chosen), this.#drawNumbers(grown, chosen)] : nothing}`;
	}

	#choose(typed: string, count: number): void {
		const number = Math.round(readTyped(typed));
		this.choose(number >= 1 && number <= count ? number - 1 : undefined);
		this.requestUpdate();
	}

	#name(grown: FlowerPlant, chosen: number): unknown {
		const { volumes } = grown;
		const place = placeOfVolume(volumes, chosen, organOf(volumes, chosen), this.#text() ?? "");
		return html`<h3 class="volume-name">${titleOfVolume(grown, chosen)}</h3><p class="volume-place">${place}</p>`;
	}

	#drawValues({ volumes }: FlowerPlant, chosen: number): unknown {
		const own = volumes.values.subarray(9 * chosen, 9 * chosen + 9);
		return html`<dl class="volume-values">
			${FIELDS.map(([name, words, unit], i) => html`<div><dt><abbr title=${words}>${name}</abbr></dt><dd>${shortFloat(Number(own[i].toPrecision(4)))}${unit && html` <small>${unit}</small>`}</dd></div>`)}
		</dl>`;
	}

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
			foot: volumes.face[footOf(volumes, chosen).foot],
		});
		const same = `${volumes.labels[label]} ${volumes.module[label]} ${volumes.line[chosen]}`;
		return html`${repeat(
			groups,
			({ title }) => `${same} ${title}`,
			(group) => this.#group(group),
		)}
		<div class="actions"><button class="button" type="button" @click=${() => this.choose(undefined)}>Let go</button></div>`;
	}

	#group({ title, tokens }: NumberGroup): unknown {
		return html`<fieldset class="volume-numbers"><legend>${title}</legend>${tokens.map((token, i) => this.#slider(token, title, i))}</fieldset>`;
	}

	#slider(token: NumberToken, title: string, index: number): unknown {
		const { name, text } = token;
		const key = `${title} ${index} ${name}`;
		const usual = token.range ? statedRange(token.range) : rangeFor(name, Number(text));
		const range = within(this.#ranges.get(key), Number(text)) ?? usual;
		this.#ranges.set(key, range);
		const { min, max, step } = range;
		const words = describeNumber(this.#text() ?? "", name);
		return html`<div class="control">${sliderRow({
			id: this.idOf(key),
			label: words ? html`<span title=${words}>${name}</span>` : name,
			name: `${name}, ${title}`,
			typedName: `${name}, ${title}, typed`,
			min,
			max,
			step,
			value: Number(text),
			text,
			help: `${words ? `${words}. ` : ""}${min} … ${max}.`,
			held: this.#held,
			slide: (value) => this.#edit(token, range.written(value), key),
			type: (typed) => {
				if (!Number.isFinite(typed)) return text;
				this.context.set(this.#changed(token, String(typed)));
				return String(typed);
			},
		})}</div>`;
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#rest();
	}

	protected override updated(): void {
		if (this.chosenIn(this.context) === undefined) this.#rest();
	}

	#edit(token: NumberToken, written: string, key: string): void {
		if (written === token.text) return;
		this.#gesture = `token ${key}`;
		this.context.edit({ ...this.#changed(token, written), run: this.#held.run }, this.#gesture);
	}

	#rest(): void {
		if (this.#gesture !== undefined) this.context.settle(this.#gesture);
		this.#gesture = undefined;
	}

	/** Returns the change that replaces a number in the text. */
	#changed({ from, to }: NumberToken, written: string) {
		const text = this.#text() ?? "";
		return withText(
			source as unknown as GrammarSource,
			this.context.state.specimen,
			text.slice(0, from) + written + text.slice(to),
		);
	}

	#text(): string | undefined {
		return textOf(source as unknown as GrammarSource, this.context.state.specimen, () => this.requestUpdate());
	}
}

customElements.define("panicle-volume", VolumePanel);
