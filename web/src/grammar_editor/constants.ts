import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { LARGEST_CONSTANT } from "../specimen/constants";
import { ControlElement } from "../ui/control_element";
import { HeldKey } from "../ui/held_key";
import { sliderRow } from "../ui/slider_row";
import { formatCount } from "../ui/thousands";
import { refusal } from "../ui/typed";
import { type Constant, type Curve, decimals, type GrammarOutline, type NumberAt } from "./outline";
import { readOutline } from "./read_outline";
import { written } from "./scrub";
import { type GrammarContext, type GrammarSource, isOwn, textOf, withText, withValues } from "./source";
import "./curve_editor";

/** Above this number of rows, the list has a search field, and only the visible rows are in the page. */
const MOST_LISTED = 60;
const NOT_FETCHED = "The list of constants could not be fetched";

/**
 * Sliders for a text's constants, and its curves. Changes are written into the document's values, or into the
 * document's own text.
 */
export class ConstantsPanel extends ControlElement<GrammarContext> {
	static override properties = { ...ControlElement.properties, source: { attribute: false } };
	declare source: GrammarSource;

	/** Search query of a long list. */
	#query = "";
	readonly #held = new HeldKey(() => this.context.settle());
	/** Message about a typed value that was not accepted as typed. */
	#message: { readonly name: string; readonly value: number; readonly text: string | undefined } | undefined;

	protected override shows(): readonly unknown[] {
		return [this.#text()];
	}

	protected override draw(): unknown {
		const { governed } = this.source;
		const { constants, curves } = this.#outline;
		const free = constants.filter(({ name }) => !governed?.has(name));
		if (free.length + curves.length === 0)
			return html`<p>A line <code>#define angle 35 /* 0 … 90 */</code> of the grammar makes a slider here.</p>`;
		if (free.length + curves.length > MOST_LISTED) return this.#longList([...free, ...curves]);
		return html`${repeat(
			free,
			({ name }) => name,
			(constant) => this.#slider(constant),
		)}
		${repeat(
			curves,
			({ name }) => name,
			(curve) => this.#curve(curve),
		)}`;
	}

	/**
	 * Draws a long list with a search field, in a box of its own height: all rows would fill the panel and take
	 * seconds to draw.
	 */
	#longList(all: readonly (Constant | Curve)[]): unknown {
		void fetchLongList(this.context);
		const words = this.#query.toLowerCase().split(/\s+/).filter(Boolean);
		const found = all.filter((each) => {
			const text = `${each.name} ${"words" in each ? each.words : ""}`.toLowerCase();
			return words.every((word) => text.includes(word));
		});
		const count = found.length === all.length ? "" : `${formatCount(found.length)} of `;
		const row = (index: number) => {
			const each = found[index];
			return "points" in each ? this.#curve(each) : this.#slider(each);
		};
		return html`<div class="find-constant" role="search" aria-label="Constants">
				<input
					type="search" aria-label="Search constants" placeholder="Search" autocomplete="off" spellcheck="false" .value=${this.#query}
					@input=${({ target }: Event) => {
						this.#query = (target as HTMLInputElement).value;
						this.requestUpdate();
					}}
				>
				<span role="status">${count}${formatCount(all.length)} constants</span>
			</div>
			<panicle-long-list .label=${"Constants"} .count=${found.length} .row=${row}></panicle-long-list>`;
	}

	#curve(curve: Curve): unknown {
		return html`<panicle-curve .curve=${curve} .write=${this.#writeCurve} .settle=${() => this.context.settle()}></panicle-curve>`;
	}

	#slider(constant: Constant): unknown {
		const { name, number, min, max, step, words } = constant;
		const published = this.#builtIn(name);
		const changed = published !== undefined && Number(published) !== number.value;
		return html`<div class="control ${changed ? "changed" : ""}">${sliderRow({
			id: this.idOf(`slide-${name}`),
			label: words ? html`<span title=${words}>${name}</span>` : name,
			typedName: `${name}, typed`,
			min,
			max,
			step,
			value: number.value,
			text: number.text,
			help: `${words ? `${words}. ` : ""}${min} … ${max}. Line ${constant.line} of the grammar.`,
			held: this.#held,
			slide: (value) => this.#edit(constant, value),
			type: (typed, text) => this.#type(name, typed, text),
			...(published === undefined ? {} : { reset: () => this.#set(name, published) }),
		})}</div>${this.#complaint(name, number.value)}`;
	}

	#type(name: string, typed: number, text: string): string {
		if (Number.isFinite(typed)) this.#set(name, String(takenOf(typed)));
		const number = this.#outline.constants.find((each) => each.name === name)?.number;
		if (!number) return "";
		this.#message = { name, value: number.value, text: complaintOf(name, text, typed, number) };
		this.requestUpdate();
		return number.text;
	}

	#complaint(name: string, value: number): unknown {
		const message = this.#message;
		if (message?.text === undefined || message.name !== name || message.value !== value) return nothing;
		return html`<p class="clamped" role="status">${message.text}</p>`;
	}

	/** Changes a constant by its slider; the number gets as many digits as the step needs. */
	#edit({ name, min, max, step, number }: Constant, value: number): void {
		const places = Math.max(decimals(String(step)), decimals(number.text));
		const text = written(Math.min(Math.max(value, min), max), places);
		const change = this.#changed(name, text);
		if (change) this.context.edit({ ...change, run: this.#held.run }, `constant ${name}`);
	}

	#set(name: string, value: string): void {
		const change = this.#changed(name, value);
		if (change) this.context.set(change);
	}

	#changed(name: string, value: string) {
		const { specimen } = this.context.state;
		if (!isOwn(specimen)) return withValues(this.source, specimen, { [name]: Number(value) });
		// In the document's own text, the number is written as typed.
		const constant = this.#outline.constants.find((each) => each.name === name);
		return constant && this.#withStretch(constant.number, value);
	}

	readonly #writeCurve = (name: string, points: string): void => {
		const curve: Curve | undefined = this.#outline.curves.find((each) => each.name === name);
		if (curve) this.context.edit(this.#withStretch(curve, points), `curve ${name}`);
	};

	/** Returns the change that replaces a range of the text. */
	#withStretch({ from, to }: { readonly from: number; readonly to: number }, insert: string) {
		const text = this.#text() ?? "";
		return withText(this.source, this.context.state.specimen, text.slice(0, from) + insert + text.slice(to));
	}

	#text(): string | undefined {
		return textOf(this.source, this.context.state.specimen, () => this.requestUpdate());
	}

	get #outline(): GrammarOutline {
		return readOutline(this.#text() ?? "", this.source.dialect);
	}

	/** Returns a constant's text in the preset's grammar. */
	#builtIn(name: string): string | undefined {
		const text = textOf(this.source, this.context.preset, () => {});
		if (text === undefined) return undefined;
		return readOutline(text, this.source.dialect).constants.find((each) => each.name === name)?.number.text;
	}
}

async function fetchLongList(context: GrammarContext): Promise<void> {
	try {
		await import("../ui/long_list");
	} catch {
		const again = () => void fetchLongList(context);
		context.notify(NOT_FETCHED, ["Part of the page could not be fetched."], { topic: NOT_FETCHED, again });
	}
}

/** Clamps a typed number to the range that links can store. */
export const takenOf = (typed: number): number => Math.min(Math.max(typed, -LARGEST_CONSTANT), LARGEST_CONSTANT);

/** Returns a message if the number accepted is not the one typed, else undefined. */
export function complaintOf(name: string, text: string, typed: number, taken: Pick<NumberAt, "text" | "value">) {
	if (typed === taken.value) return undefined;
	return refusal(name, `${-LARGEST_CONSTANT} … ${LARGEST_CONSTANT}.`, text, typed, taken.text);
}

customElements.define("panicle-constants", ConstantsPanel);
