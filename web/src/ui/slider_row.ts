import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { coarseStep } from "./coarse_step";
import type { HeldKey } from "./held_key";
import { text as message } from "./messages.generated";
import { handBack, handOver, isForField, readTyped } from "./typed";
import "./info";

/** A number with a slider and a field. */
export interface SliderRow {
	/** Id of the slider in the page. */
	readonly id: string;
	readonly label: unknown;
	/** The label in words, or more words if the label is not sufficient. */
	readonly name: string;
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
	/** The preset's value in words, which `reset` restores. */
	readonly published?: string;
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
 * Draws the content of a `.control`: label, slider, the field beside it with its unit, and a button that explains the
 * number. Slider and field are one stop of the Tab key: Enter or a digit on the slider moves the focus to the field, and Enter or Escape there moves it back. Redrawing
 * retains unfinished typing.
 */
export function sliderRow(row: SliderRow): TemplateResult {
	const { id, min, max, step, value, text, unit = "", held, reset } = row;
	const help = `${id}-help`;
	const press = (event: KeyboardEvent) => {
		if (reset && (event.key === "Delete" || event.key === "Backspace")) return reset();
		if (isForField(event)) return handOver(event, siblingInput(event, TYPED));
		held.down(event);
		const coarse = coarseStep(step, event);
		if (coarse === undefined) return;
		event.preventDefault();
		row.slide(value + coarse);
	};
	const type = ({ target }: Event) => {
		const field = target as HTMLInputElement;
		field.value = row.type(readTyped(field.value), field.value);
	};
	return html`<label for=${id} @dblclick=${reset}>${row.label}</label>
		<input
			type="range" id=${id} min=${min} max=${max} step=${step} .value=${live(String(value))} .style=${`--done: ${doneIn(row)}%`}
			aria-label=${row.name} aria-valuetext=${row.spoken ?? nothing} aria-describedby=${help}
			@input=${({ target }: Event) => row.slide(Number((target as HTMLInputElement).value))} @change=${held.slid} @dblclick=${reset}
			@keydown=${press} @keyup=${held.up} @blur=${held.up}
		>
		<span class="field"><input
			class="typed" type="text" inputmode="decimal" autocomplete="off" tabindex="-1" .value=${text}
			aria-label=${row.typedName} aria-describedby=${help}
			@change=${type} @focus=${({ target }: Event) => (target as HTMLInputElement).select()}
			@keydown=${(event: KeyboardEvent) => handBack(event, text, siblingInput(event, SLIDER))}
		><span class="unit" aria-hidden="true">${unit}</span></span>
		<panicle-info .name=${row.name} .text=${explanation(row.help, row.published)}></panicle-info>
		<span class="unseen" id=${help}>${row.help} ${message("slider_keys")}</span>`;
}

/** Returns how far the slider is filled, in percent. */
const doneIn = ({ min, max, value }: SliderRow): number => (100 * (value - min)) / (max - min);

/** Returns the explanation of a control: its help, and how to restore the preset's value if there is one. */
export const explanation = (help: string, published: string | undefined): string =>
	published === undefined ? help : `${help} ${message("reset_hint", { value: published })}`;

/** Returns an input of the same row. */
function siblingInput({ currentTarget }: Event, selector: string): HTMLInputElement | null {
	return (currentTarget as HTMLElement).closest(".control")?.querySelector<HTMLInputElement>(selector) ?? null;
}
