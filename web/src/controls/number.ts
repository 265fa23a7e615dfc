import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { readIn, readOf, type Scale, scaleOf } from "../specimen/lengths";
import { type NumberEntry, nearestWithin } from "../specimen/table";
import { coarseStep } from "./coarse_step";
import type { Change } from "./desk";
import { EntryElement } from "./entry_element";
import { HeldKey } from "./held_key";
import { OWN_LENGTHS } from "./own_lengths";
import { symbol } from "./symbol";
import { handBack, handOver, isForField, readTyped } from "./typed";

/**
 * One numeric parameter: a slider and the same number to type. Dragging edits live and is one undo step, as is a run of
 * a held key.
 */
export class NumberControl extends EntryElement<NumberEntry> {
	/** What became of a value that could not be taken as typed. */
	#message: { text: string | undefined; value: number } | undefined;
	readonly #held = new HeldKey(() => this.desk.settle());

	protected override shows(): readonly unknown[] {
		return [...super.shows(), this.#scale.per, this.desk.toolState(OWN_LENGTHS)];
	}

	/** How its value is read: lengths in millimetres. */
	get #scale(): Scale {
		const { model, specimen } = this.desk.state;
		return scaleOf(model, specimen, this.entry);
	}

	protected override draw(): unknown {
		const { entry } = this;
		const value = Number(this.value);
		const scale = this.#scale;
		const { key, label } = entry;
		const { unit } = scale;
		const read = readOf(entry, scale, value);
		const own = unit !== entry.unit && this.desk.toolState(OWN_LENGTHS);
		const [slide, help] = [this.idOf("slide"), this.idOf("help")];
		return html`<div class="control ${value === this.published ? "" : "changed"}" data-key=${key}>
			<label for=${slide} @dblclick=${this.reset}>${label}${symbol(entry.symbol)}${own ? html` <small>${value} ${entry.unit}</small>` : nothing}</label>
			<input
				type="range" id=${slide} min=${entry.min} max=${entry.max} step=${entry.step} .value=${live(String(value))}
				aria-valuetext=${`${read} ${spoken(unit)}`.trim()} aria-describedby=${help}
				@input=${this.#slide} @change=${this.#held.slid} @dblclick=${this.reset}
				@keydown=${this.#keyDown} @keyup=${this.#held.up} @blur=${this.#held.up}
			>
			<input
				class="typed" type="text" inputmode="decimal" autocomplete="off" tabindex="-1" .value=${String(read)}
				aria-label=${unit ? `${label} in ${spoken(unit)}` : `${label}, typed`} aria-describedby=${help}
				@change=${this.#type} @keydown=${this.#fieldKey} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			>
			<span class="unit" aria-hidden="true">${unit}</span>
			<span class="unseen" id=${help}>${entry.help} ${rangeInWords(entry, scale)} Shift goes ten steps. Enter types a number.</span>
			</div>
			${this.#message?.text && this.#message.value === value ? html`<p class="clamped" role="status">${this.#message.text}</p>` : nothing}`;
	}

	protected override updated(): void {
		const { min, max } = this.entry;
		const done = (Number(this.value) - min) / (max - min);
		this.querySelector<HTMLElement>("input[type=range]")?.style.setProperty("--done", `${done * 100}%`);
	}

	protected override change(value: number): Change {
		return super.change(nearestWithin(this.entry, value));
	}

	protected override reset(): void {
		this.#message = undefined;
		super.reset();
	}

	#slide(event: Event): void {
		this.#message = undefined;
		this.#edit(Number((event.target as HTMLInputElement).value));
		this.requestUpdate(); // Where the value taken is another, the slider goes there too.
	}

	#edit(value: number): void {
		this.desk.edit({ ...this.change(value), run: this.#held.run });
	}

	#keyDown(event: KeyboardEvent): void {
		if (event.key === "Delete" || event.key === "Backspace") this.reset();
		else if (isForField(event)) handOver(event, this.querySelector("input.typed"));
		else {
			this.#held.down(event);
			this.#stepFar(event);
		}
	}

	#stepFar(event: KeyboardEvent): void {
		const by = coarseStep(this.entry.step, event);
		if (by === undefined) return;
		event.preventDefault();
		this.#message = undefined;
		this.#edit(Number(this.value) + by);
	}

	#fieldKey(event: KeyboardEvent): void {
		handBack(event, readIn(this.#scale, Number(this.value)), this.querySelector("input[type=range]"));
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const typed = readTyped(field.value);
		const scale = this.#scale;
		if (Number.isFinite(typed)) this.desk.set(this.change(typed / scale.per));
		const value = Number(this.value);
		this.#message = { text: complaint(this.entry, scale, field.value, typed, value), value };
		field.value = readOf(this.entry, scale, value);
		this.requestUpdate();
	}
}

/** What to say where the number taken is not the one typed. */
function complaint(entry: NumberEntry, scale: Scale, text: string, typed: number, value: number): string | undefined {
	const taken = readOf(entry, scale, value);
	if (!Number.isFinite(typed)) return `“${text.slice(0, 20)}” is not a number; ${entry.label} stays ${taken}.`;
	// What is typed finer than it is read was taken all the same.
	if (Math.abs(typed - scale.per * value) < (scale.per === 1 ? 1e-9 : 10 ** -scale.decimals)) return undefined;
	return `${entry.label} takes ${rangeInWords(entry, scale)} ${typed} became ${taken}.`;
}

/** "12.5 … 250 mm." */
function rangeInWords({ min, max, kind }: NumberEntry, scale: Scale): string {
	const { unit } = scale;
	return `${kind === "integer" && scale.per === 1 ? "whole numbers " : ""}${readIn(scale, min)} … ${readIn(scale, max)}${unit ? ` ${unit}` : ""}.`;
}

const SPOKEN: Readonly<Record<string, string>> = {
	px: "pixels",
	mm: "millimetres",
	"×": "times",
	"°": "degrees",
	"%": "percent",
	u: "units",
};

function spoken(unit: string): string {
	return SPOKEN[unit] ?? unit;
}

customElements.define("panicle-number", NumberControl);
