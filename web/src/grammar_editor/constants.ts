import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { LARGEST_CONSTANT } from "../specimen/constants";
import { ControlElement } from "../ui/control_element";
import { HeldKey } from "../ui/held_key";
import { sliderRow } from "../ui/slider_row";
import { spoken } from "../ui/spoken";
import { refusal, typedName } from "../ui/typed";
import { type Constant, type Curve, decimals, type GrammarOutline, type NumberAt } from "./outline";
import { readOutline } from "./read_outline";
import { written } from "./scrub";
import {
	basicConstants,
	type GrammarContext,
	type GrammarSource,
	isOwn,
	labelOf,
	textOf,
	withText,
	withValues,
} from "./source";
import "./curve_editor";
import { text } from "./messages.generated";

/** Above this number of rows, the list has a search field, and only the visible rows are in the page. */
const MAX_LISTED = 60;

/**
 * Sliders for a text's constants, and its curves. Changes are written into the document's values, or into the
 * document's own text.
 */
export class ConstantsPanel extends ControlElement<GrammarContext> {
	static override properties = {
		...ControlElement.properties,
		source: { attribute: false },
		shown: { attribute: false },
	};
	declare source: GrammarSource;
	/** The constants to show: those among the panel's basics, or all others and the curves. */
	declare shown: "basics" | "others";

	/** Search query of a long list. */
	#query = "";
	readonly #held = new HeldKey(() => this.context.settle());
	/** Message about a typed value that was not accepted as typed. */
	#message: { readonly name: string; readonly value: number; readonly text: string | undefined } | undefined;

	/** Returns the values whose change redraws the panel: the text. */
	protected override shows(): readonly unknown[] {
		return [this.#text()];
	}

	/** Renders sliders for the constants, then the curves; a long list renders only its visible rows. */
	protected override draw({ state: { specimen } }: GrammarContext): unknown {
		const { constants, curves } = this.#outline;
		const settable = constants.filter(({ name }) => !this.source.governed?.has(name));
		const basics = basicConstants(this.source, specimen, constants);
		if (this.shown === "basics") return this.#sliders(basics);
		const free = settable.filter((constant) => !basics.includes(constant));
		if (settable.length + curves.length === 0)
			return html`<p>${text.pieces("constants_none", { example: html`<code>#define angle 35 /* 0 … 90 */</code>` })}</p>`;
		if (free.length + curves.length === 0) return html`<p>${text("constants_in_basics")}</p>`;
		if (free.length + curves.length > MAX_LISTED) return this.#longList([...free, ...curves]);
		return html`${this.#sliders(free)}
		${repeat(
			curves,
			({ name }) => name,
			(curve) => this.#curve(curve),
		)}`;
	}

	#sliders(constants: readonly Constant[]): unknown {
		return repeat(
			constants,
			({ name }) => name,
			(constant) => this.#slider(constant),
		);
	}

	/**
	 * Draws a long list with a search field, in a box of its own height: all rows would fill the panel and take
	 * seconds to draw.
	 */
	#longList(constants: readonly (Constant | Curve)[]): unknown {
		void fetchLongList(this.context);
		const words = this.#query.toLowerCase().split(/\s+/).filter(Boolean);
		const matching = constants.filter((each) => {
			const searched = `${each.name} ${"description" in each ? each.description : ""}`.toLowerCase();
			return words.every((word) => searched.includes(word));
		});
		const count =
			matching.length === constants.length
				? text("constants_count", { count: constants.length })
				: text("constants_found", { found: matching.length, count: constants.length });
		const row = (index: number) => {
			const each = matching[index];
			return "points" in each ? this.#curve(each) : this.#slider(each);
		};
		return html`<div class="find-constant" role="search" aria-label=${text("constants")}>
				<input
					type="search" aria-label=${text("constants_search")} placeholder=${text("search")} autocomplete="off" spellcheck="false" .value=${this.#query}
					@input=${({ target }: Event) => {
						this.#query = (target as HTMLInputElement).value;
						this.requestUpdate();
					}}
				>
				<span role="status">${count}</span>
			</div>
			<panicle-long-list .label=${text("constants")} .count=${matching.length} .row=${row}></panicle-long-list>`;
	}

	/** Draws the editor of a curve. */
	#curve(curve: Curve): unknown {
		return html`<panicle-curve .curve=${curve} .write=${this.#writeCurve} .settle=${() => this.context.settle()}></panicle-curve>`;
	}

	/** Draws the slider of a constant; a constant that differs from the preset is marked. */
	#slider(constant: Constant): unknown {
		const { name, number, min, max, step, description } = constant;
		// Under "Advanced" constants have the names that the text has.
		const { label, unit } =
			this.shown === "basics" ? labelOf(this.source, constant) : { label: name, unit: constant.unit };
		const published = this.#builtIn(name);
		const range = { least: String(min), most: String(max), line: String(constant.line) };
		const changed = published !== undefined && Number(published) !== number.value;
		return html`<div class="control ${changed ? "changed" : ""}">${sliderRow({
			id: this.idOf(`slide-${name}`),
			label: description ? html`<span title=${description}>${label}</span>` : label,
			name: label,
			typedName: typedName(label, unit),
			unit,
			...(unit === "" ? {} : { spoken: `${number.text} ${spoken(unit)}` }),
			min,
			max,
			step,
			value: number.value,
			text: number.text,
			help: description ? text("constant_help_described", { ...range, description }) : text("constant_help", range),
			held: this.#held,
			slide: (value) => this.#edit(constant, value),
			type: (typed, written) => this.#type(name, typed, written),
			...(published === undefined ? {} : { published, reset: () => this.#setConstant(name, published) }),
		})}</div>${this.#complaint(name, number.value)}`;
	}

	/**
	 * Sets a constant to a typed number, within the range that links can store, and prepares the message on a number that
	 * was not accepted as typed.
	 * @param typed the number, NaN if the text is none
	 * @returns the text that the field shows then
	 */
	#type(name: string, typed: number, text: string): string {
		if (Number.isFinite(typed)) this.#setConstant(name, String(takenOf(typed)));
		const number = this.#outline.constants.find((each) => each.name === name)?.number;
		if (!number) return "";
		this.#message = { name, value: number.value, text: complaintOf(name, text, typed, number) };
		this.requestUpdate();
		return number.text;
	}

	/**
	 * Draws the message on the last typed value of a constant, as long as the constant still has the value set then.
	 */
	#complaint(name: string, value: number): unknown {
		const message = this.#message;
		if (message?.text === undefined || message.name !== name || message.value !== value) return nothing;
		return html`<p class="clamped" role="status">${message.text}</p>`;
	}

	/** Changes a constant by its slider; the number gets as many digits as the step needs. */
	#edit({ name, min, max, step, number }: Constant, value: number): void {
		const places = Math.max(decimals(String(step)), decimals(number.text));
		const text = written(Math.min(Math.max(value, min), max), places);
		const change = this.#changeOf(name, text);
		if (change) this.context.edit({ ...change, run: this.#held.run }, `constant ${name}`);
	}

	/** Sets a constant as a finished change. */
	#setConstant(name: string, value: string): void {
		const change = this.#changeOf(name, value);
		if (change) this.context.set(change);
	}

	/** Returns the change that sets a constant; undefined while the text loads. */
	#changeOf(name: string, value: string) {
		const { specimen } = this.context.state;
		if (!isOwn(specimen)) return withValues(this.source, specimen, { [name]: Number(value) });
		// In the document's own text, the number is written as typed.
		const constant = this.#outline.constants.find((each) => each.name === name);
		return constant && this.#replaceRange(constant.number, value);
	}

	/** Writes the points of a curve into the document's text, as part of a drag. */
	readonly #writeCurve = (name: string, points: string): void => {
		const curve: Curve | undefined = this.#outline.curves.find((each) => each.name === name);
		if (curve) this.context.edit(this.#replaceRange(curve, points), `curve ${name}`);
	};

	/**
	 * Returns the change that replaces a range of the document's text.
	 * @param insert the new content of the range
	 */
	#replaceRange({ from, to }: { readonly from: number; readonly to: number }, insert: string) {
		const text = this.#text() ?? "";
		return withText(this.source, this.context.state.specimen, text.slice(0, from) + insert + text.slice(to));
	}

	/** Returns the document's text; undefined while the built-in text loads, after which the panel is drawn again. */
	#text(): string | undefined {
		return textOf(this.source, this.context.state.specimen, () => this.requestUpdate());
	}

	/** Constants and curves of the text; none while the text loads. */
	get #outline(): GrammarOutline {
		return readOutline(this.#text() ?? "", this.source.dialect);
	}

	/**
	 * Returns a constant's number, as written, in the preset's grammar; undefined while that loads, or without such a
	 * constant.
	 */
	#builtIn(name: string): string | undefined {
		const text = textOf(this.source, this.context.preset, () => {});
		if (text === undefined) return undefined;
		return readOutline(text, this.source.dialect).constants.find((each) => each.name === name)?.number.text;
	}
}

/** Loads the element of long lists; a failure shows a notice with a button that tries again. */
async function fetchLongList(context: GrammarContext): Promise<void> {
	try {
		await import("../ui/long_list");
	} catch {
		const again = () => void fetchLongList(context);
		const failed = text("list_not_loaded");
		context.notify(failed, [text("part_not_loaded")], { topic: failed, again });
	}
}

/** Clamps a typed number to the range that links can store. */
export const takenOf = (typed: number): number => Math.min(Math.max(typed, -LARGEST_CONSTANT), LARGEST_CONSTANT);

/** Returns a message if the number accepted is not the one typed, else undefined. */
export function complaintOf(name: string, written: string, typed: number, taken: Pick<NumberAt, "text" | "value">) {
	if (typed === taken.value) return undefined;
	const range = text("constant_range", { least: String(-LARGEST_CONSTANT), most: String(LARGEST_CONSTANT) });
	return refusal(name, range, written, typed, taken.text);
}

customElements.define("panicle-constants", ConstantsPanel);
