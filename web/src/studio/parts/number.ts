import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import type { ParameterInfo } from "../../models/bunch/parameters.generated";
import type { Specimen } from "../../specimen/specimen";
import { entryOf, type NumberEntry, nearestWithin } from "../../specimen/table";
import type { Change } from "../types";
import { StudioElement } from "./studio_element";
import { symbol } from "./symbol";

const MOVING_KEYS = /^(Arrow|Page|Home|End)/;

/**
 * One numeric parameter: a slider and the same number to type. Dragging edits live and is one undo step, as is a run of
 * a held key; a double click on the name or the slider, or Delete, brings the preset's value back.
 */
export class NumberControl extends StudioElement {
	static override properties = { ...StudioElement.properties, info: { attribute: false }, message: { state: true } };
	declare info: ParameterInfo;
	/** What became of a value that could not be taken as typed. */
	declare private message: { text: string | undefined; value: number } | undefined;

	#keyHeld = false;
	#drawn: readonly [value: number, preset: number] | undefined;

	protected override concerns(): boolean {
		return this.value !== this.#drawn?.[0] || this.presetValue !== this.#drawn[1];
	}

	protected override draw(): unknown {
		const { info, value, presetValue } = this;
		const { key, label, unit } = info;
		this.#drawn = [value, presetValue];
		const changed = value !== presetValue;
		return html`<div class="control ${changed ? "changed" : ""}" data-key=${key}>
			<label for="slide-${key}" @dblclick=${this.#reset}
				>${label}${symbol(info.symbol)}</label
			>
			<input
				type="range" id="slide-${key}" min=${info.min ?? 0} max=${info.max ?? 1} step=${info.step ?? 1} .value=${live(String(value))}
				aria-valuetext=${`${value} ${spoken(unit)}`.trim()} aria-describedby="help-${key}"
				@input=${this.#slide} @change=${this.#slid} @dblclick=${this.#reset}
				@keydown=${this.#keyDown} @keyup=${this.#keyUp} @blur=${this.#keyUp}
			>
			<input
				class="typed" type="text" inputmode="decimal" autocomplete="off" .value=${String(value)}
				aria-label=${unit ? `${label} in ${spoken(unit)}` : `${label}, typed`} aria-describedby="help-${key}"
				@change=${this.#type} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			>
			<span class="unit" aria-hidden="true">${unit}</span>
			<span class="unseen" id="help-${key}">${info.help} ${range(info)}</span>
			</div>
			${this.message?.text && this.message.value === value ? html`<p class="clamped" role="status">${this.message.text}</p>` : nothing}`;
	}

	protected override updated(): void {
		const slider = this.querySelector<HTMLInputElement>("input[type=range]");
		const { min = 0, max = 1 } = this.info;
		slider?.style.setProperty("--done", `${((this.value - min) / (max - min)) * 100}%`);
	}

	private get value(): number {
		return numberIn(this.studio.state.specimen, this.info);
	}

	private get presetValue(): number {
		return numberIn(this.studio.preset, this.info);
	}

	#change(value: number): Change {
		const fitted = nearestWithin(entryOf(this.info.key) as NumberEntry, value);
		return this.info.look ? { look: { [this.info.key]: fitted } } : { parameters: { [this.info.key]: fitted } };
	}

	#slide(event: Event): void {
		this.message = undefined;
		this.studio.edit(this.#change(Number((event.target as HTMLInputElement).value)));
		this.requestUpdate(); // Where the value taken is another, the slider goes there too.
	}

	#slid(): void {
		if (!this.#keyHeld) this.studio.settle();
	}

	#keyDown(event: KeyboardEvent): void {
		if (event.key === "Delete" || event.key === "Backspace") this.#reset();
		else if (MOVING_KEYS.test(event.key)) this.#keyHeld = true;
	}

	#keyUp(): void {
		if (this.#keyHeld) this.studio.settle();
		this.#keyHeld = false;
	}

	#reset(): void {
		this.message = undefined;
		this.studio.set(this.#change(this.presetValue));
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const text = field.value.trim().replace(",", ".").replace("−", "-");
		const typed = text === "" ? Number.NaN : Number(text);
		if (Number.isFinite(typed)) this.studio.set(this.#change(typed));
		this.message = { text: complaint(this.info, field.value, typed, this.value), value: this.value };
		field.value = String(this.value);
	}
}

function numberIn({ look, parameters }: Specimen, { key }: ParameterInfo): number {
	return Number({ ...parameters, ...look }[key]);
}

/** What to say where the number taken is not the one typed. */
export function complaint(info: ParameterInfo, text: string, typed: number, taken: number): string | undefined {
	if (!Number.isFinite(typed)) return `“${text.slice(0, 20)}” is not a number; ${info.label} stays ${taken}.`;
	if (Math.abs(typed - taken) < 1e-9) return undefined;
	return `${info.label} takes ${range(info)} ${typed} became ${taken}.`;
}

/** "29 … 580 px." */
function range({ min, max, unit, kind }: ParameterInfo): string {
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
