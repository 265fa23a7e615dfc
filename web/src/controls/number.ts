import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { type NumberEntry, nearestWithin } from "../specimen/table";
import { coarseStep } from "./coarse_step";
import type { Change } from "./desk";
import { EntryElement } from "./entry_element";
import { HeldKey } from "./held_key";
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

	protected override draw(): unknown {
		const { entry } = this;
		const value = Number(this.value);
		const { key, label, unit } = entry;
		const [slide, help] = [this.idOf("slide"), this.idOf("help")];
		return html`<div class="control ${value === this.published ? "" : "changed"}" data-key=${key}>
			<label for=${slide} @dblclick=${this.reset}>${label}${symbol(entry.symbol)}</label>
			<input
				type="range" id=${slide} min=${entry.min} max=${entry.max} step=${entry.step} .value=${live(String(value))}
				aria-valuetext=${`${value} ${spoken(unit)}`.trim()} aria-describedby=${help}
				@input=${this.#slide} @change=${this.#held.slid} @dblclick=${this.reset}
				@keydown=${this.#keyDown} @keyup=${this.#held.up} @blur=${this.#held.up}
			>
			<input
				class="typed" type="text" inputmode="decimal" autocomplete="off" tabindex="-1" .value=${String(value)}
				aria-label=${unit ? `${label} in ${spoken(unit)}` : `${label}, typed`} aria-describedby=${help}
				@change=${this.#type} @keydown=${this.#fieldKey} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			>
			<span class="unit" aria-hidden="true">${unit}</span>
			<span class="unseen" id=${help}>${entry.help} ${range(entry)} Shift goes ten steps. Enter types a number.</span>
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
		this.desk.edit(this.change(Number((event.target as HTMLInputElement).value)));
		this.requestUpdate(); // Where the value taken is another, the slider goes there too.
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
		this.desk.edit(this.change(Number(this.value) + by));
	}

	#fieldKey(event: KeyboardEvent): void {
		handBack(event, Number(this.value), this.querySelector("input[type=range]"));
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const typed = readTyped(field.value);
		if (Number.isFinite(typed)) this.desk.set(this.change(typed));
		const taken = Number(this.value);
		this.#message = { text: complaint(this.entry, field.value, typed, taken), value: taken };
		field.value = String(taken);
		this.requestUpdate();
	}
}

/** What to say where the number taken is not the one typed. */
export function complaint(entry: NumberEntry, text: string, typed: number, taken: number): string | undefined {
	if (!Number.isFinite(typed)) return `“${text.slice(0, 20)}” is not a number; ${entry.label} stays ${taken}.`;
	if (Math.abs(typed - taken) < 1e-9) return undefined;
	return `${entry.label} takes ${range(entry)} ${typed} became ${taken}.`;
}

/** "29 … 580 px." */
function range({ min, max, unit, kind }: NumberEntry): string {
	return `${kind === "integer" ? "whole numbers " : ""}${min} … ${max}${unit ? ` ${unit}` : ""}.`;
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
