import { html, nothing } from "lit";
import { type DisplayScale, displayedText, displayScaleOf, parseDisplayed, rangeInWords } from "../specimen/lengths";
import { type NumberEntry, nearestWithin } from "../specimen/table";
import type { Change } from "./editor_context";
import { EntryElement } from "./entry_element";
import { HeldKey } from "./held_key";
import { OWN_LENGTHS } from "./own_lengths";
import { sliderRow } from "./slider_row";
import { spoken } from "./spoken";
import { symbol } from "./symbol";
import { refusal, typedName } from "./typed";

/** Control of a number: a slider and a field. A drag edits live and is one undo step, as is a run of key presses. */
export class NumberControl<E extends NumberEntry = NumberEntry> extends EntryElement<E> {
	/** Message about a typed value that was not accepted as typed. */
	#message: { text: string | undefined; value: number } | undefined;
	readonly #held = new HeldKey(() => this.context.settle());

	/** Returns the values whose change redraws the control: the value, the preset's value, or the unit of display. */
	protected override shows(): readonly unknown[] {
		return [...super.shows(), this.#scale.per, this.context.toolState(OWN_LENGTHS)];
	}

	/** DisplayScale of the displayed value: lengths are in millimetres. */
	get #scale(): DisplayScale {
		const { model, specimen } = this.context.state;
		return displayScaleOf(model, specimen, this.entry);
	}

	/** Renders a slider with a text field, in the units that the reader chose. */
	protected override draw(): unknown {
		const { entry, published } = this;
		const value = Number(this.value);
		const scale = this.#scale;
		const { key, label } = entry;
		const { unit } = scale;
		const read = displayedText(entry, scale, value);
		const own = unit !== entry.unit && this.context.toolState(OWN_LENGTHS);
		return html`<div class="control ${published === undefined || value === published ? "" : "changed"}" data-key=${key}>${sliderRow(
			{
				id: this.idOf("slide"),
				label: html`${label}${symbol(entry.symbol)}${own ? html` <small>${value} ${entry.unit}</small>` : nothing}`,
				name: label,
				typedName: typedName(label, unit),
				min: entry.min,
				max: entry.max,
				step: entry.step,
				value,
				text: read,
				unit,
				spoken: `${read} ${spoken(unit)}`.trim(),
				help: `${entry.help} ${rangeInWords(entry, scale)}`,
				...(published === undefined
					? {}
					: { published: `${displayedText(entry, scale, Number(published))} ${unit}`.trim() }),
				held: this.#held,
				slide: this.#slide,
				type: this.#type,
				reset: () => this.reset(),
			},
		)}</div>
			${this.#message?.text && this.#message.value === value ? html`<p class="clamped" role="status">${this.#message.text}</p>` : nothing}`;
	}

	/** Returns the change that sets the nearest value that is allowed. */
	protected override change(value: number): Change {
		return super.change(nearestWithin(this.entry, value));
	}

	/** Restores the preset's value, without the message on a typed one. */
	protected override reset(): void {
		this.#message = undefined;
		super.reset();
	}

	/** Sets the value during a drag or a run of key presses. */
	readonly #slide = (value: number): void => {
		this.#message = undefined;
		this.context.edit({ ...this.change(value), run: this.#held.run });
		this.requestUpdate(); // If another value was accepted, the slider moves there.
	};

	/** Sets a typed number, in the displayed unit, and prepares the message on one that was not accepted as typed. */
	readonly #type = (number: number, text: string): string => {
		const scale = this.#scale;
		const typed = parseDisplayed(this.entry, text, number);
		if (Number.isFinite(typed)) this.context.set(this.change(typed / scale.per));
		const value = Number(this.value);
		this.#message = { text: complaint(this.entry, scale, text, typed, value), value };
		this.requestUpdate();
		return displayedText(this.entry, scale, value);
	};
}

/** Returns a message if the number accepted is not the one typed, else undefined. */
function complaint(
	entry: NumberEntry,
	scale: DisplayScale,
	text: string,
	typed: number,
	value: number,
): string | undefined {
	// More decimals than the field shows were accepted.
	if (Math.abs(typed - scale.per * value) < (scale.per === 1 ? 1e-9 : 10 ** -scale.decimals)) return undefined;
	return refusal(entry.label, rangeInWords(entry, scale), text, typed, displayedText(entry, scale, value));
}

customElements.define("panicle-number", NumberControl);
