import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { coarseStep } from "./coarse_step";
import type { HeldKey } from "./held_key";
import { handBack, handOver, isForField, readTyped } from "./typed";

/** A number with a slider and a field. */
export interface SliderRow {
	/** Id of the slider in the page. */
	readonly id: string;
	readonly label: unknown;
	/** Accessible name of the slider, if its label is not sufficient. */
	readonly name?: string;
	/** Accessible name of the field. */
	readonly typedName: string;
	readonly min: number;
	readonly max: number;
	readonly step: number;
	readonly value: number;
	/** The value as the field shows it. */
	readonly text: string;
	readonly unit?: string;
	/** The value in words, if the number is not sufficient. */
	readonly spoken?: string;
	/** Effect and range of the number. */
	readonly help: string;
	readonly held: HeldKey;
	/** Called during a drag with any value, which may lie beyond the ends. */
	readonly slide: (value: number) => void;
	/**
	 * Called with a typed number, NaN for other text.
	 * @returns the text that the field shows then
	 */
	readonly type: (typed: number, text: string) => string;
	/** Called by Delete, or a double click. */
	readonly reset?: () => void;
}

const TYPED = "input.typed";
const SLIDER = "input[type=range]";

/**
 * Draws the content of a `.control`: label, slider, the field beside it, its unit. The row is one stop of the Tab key:
 * Enter or a digit on the slider moves the focus to the field, and Enter or Escape there moves it back. Redrawing
 * retains unfinished typing.
 */
export function sliderRow(row: SliderRow): TemplateResult {
	const { id, min, max, step, value, text, unit = "", held, reset } = row;
	const help = `${id}-help`;
	const press = (event: KeyboardEvent) => {
		if (reset && (event.key === "Delete" || event.key === "Backspace")) return reset();
		if (isForField(event)) return handOver(event, beside(event, TYPED));
		held.down(event);
		const by = coarseStep(step, event);
		if (by === undefined) return;
		event.preventDefault();
		row.slide(value + by);
	};
	const type = ({ target }: Event) => {
		const field = target as HTMLInputElement;
		field.value = row.type(readTyped(field.value), field.value);
	};
	return html`<label for=${id} @dblclick=${reset}>${row.label}</label>
		<input
			type="range" id=${id} min=${min} max=${max} step=${step} .value=${live(String(value))} .style=${`--done: ${doneIn(row)}%`}
			aria-label=${row.name ?? nothing} aria-valuetext=${row.spoken ?? nothing} aria-describedby=${help} data-help=${row.help}
			@input=${({ target }: Event) => row.slide(Number((target as HTMLInputElement).value))} @change=${held.slid} @dblclick=${reset}
			@keydown=${press} @keyup=${held.up} @blur=${held.up}
		>
		<input
			class="typed" type="text" inputmode="decimal" autocomplete="off" tabindex="-1" .value=${text}
			aria-label=${row.typedName} aria-describedby=${help}
			@change=${type} @focus=${({ target }: Event) => (target as HTMLInputElement).select()}
			@keydown=${(event: KeyboardEvent) => handBack(event, text, beside(event, SLIDER))}
		>
		<span class="unit" aria-hidden="true">${unit}</span>
		<span class="unseen" id=${help}>${row.help} Shift goes ten steps. Enter types a number.</span>`;
}

const doneIn = ({ min, max, value }: SliderRow): number => (100 * (value - min)) / (max - min);

function beside({ currentTarget }: Event, selector: string): HTMLInputElement | null {
	return (currentTarget as HTMLElement).parentElement?.querySelector<HTMLInputElement>(selector) ?? null;
}
