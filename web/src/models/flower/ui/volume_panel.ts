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
import { type NumberRange, rangeFor, statedRange, within } from "./number_range";
import { describeNumber, FIELDS } from "./number_words";
import { footOf, organOf, placeOfVolume, titleOfVolume } from "./organ";
import { source } from "./text";
import { type NumberGroup, type NumberToken, numberGroupsOf } from "./token_edits";

/** The numbers of the chosen volume, and sliders of what the text says of it: what they change is written into the text. */
export class VolumePanel extends ControlElement<EditorContext<FlowerSpecimen, FlowerPlant>> {
	static override properties = {
		...ControlElement.properties,
		chosenIn: { attribute: false },
		choose: { attribute: false },
	};
	/** VolumeOrigin of what stands now: a number that was told may be of a flower that has gone. */
	declare chosenIn: (context: EditorContext<FlowerSpecimen, FlowerPlant>) => number | undefined;
	declare choose: (volume: number | undefined) => void;

	readonly #held = new HeldKey(() => this.context.settle());
	/** What a slider has begun last: it may go from under the hand, with the volume that it tells of. */
	#gesture: string | undefined;
	/** How far sliders reach: a range does not run away from the hand. */
	readonly #ranges = new Map<string, NumberRange>();

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
			${grown && chosen !== undefined ? [this.#tell(grown, chosen), this.#said(grown, chosen)] : nothing}`;
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

	#tell({ volumes }: FlowerPlant, chosen: number): unknown {
		const own = volumes.values.subarray(9 * chosen, 9 * chosen + 9);
		return html`<dl class="volume-values">
			${FIELDS.map(([name, words, unit], i) => html`<div><dt><abbr title=${words}>${name}</abbr></dt><dd>${shortFloat(Number(own[i].toPrecision(4)))}${unit && html` <small>${unit}</small>`}</dd></div>`)}
		</dl>`;
	}

	#said({ volumes }: FlowerPlant, chosen: number): unknown {
		const text = this.#text();
		if (text === undefined) return nothing;
		const label = volumes.label[chosen];
		const said = numberGroupsOf(text, {
			label: volumes.labels[label],
			module: volumes.module[label],
			line: volumes.line[chosen],
			call: volumes.call[chosen],
			face: volumes.face[chosen],
			foot: volumes.face[footOf(volumes, chosen).foot],
		});
		const same = `${volumes.labels[label]} ${volumes.module[label]} ${volumes.line[chosen]}`;
		return html`${repeat(
			said,
			({ title }) => `${same} ${title}`,
			(group) => this.#group(group),
		)}
		<div class="actions"><button class="button" type="button" @click=${() => this.choose(undefined)}>Let go</button></div>`;
	}

	#group({ title, tokens }: NumberGroup): unknown {
		return html`<fieldset class="volume-said"><legend>${title}</legend>${tokens.map((token, i) => this.#slider(token, title, i))}</fieldset>`;
	}

	#slider(token: NumberToken, title: string, index: number): unknown {
		const { name, text } = token;
		const key = `${title} ${index} ${name}`;
		const said = token.range ? statedRange(token.range) : rangeFor(name, Number(text));
		const range = within(this.#ranges.get(key), Number(text)) ?? said;
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

	/** The change that writes a token in the place of another. */
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
