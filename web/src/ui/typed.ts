/** Typed numbers: the field beside a slider. It is no stop of the Tab key; keys on the slider move the focus to it. */

import { text } from "./messages.generated";
import { spoken } from "./spoken";

/** Reads a number as people type it: with a decimal comma, or a typographic minus; NaN if it is no number. */
export function readTyped(text: string): number {
	const plain = text.trim().replace(",", ".").replace("−", "-");
	return plain === "" ? Number.NaN : Number(plain);
}

/**
 * Returns a message if the number accepted differs from the typed text.
 * @param range a sentence: "1 … 21."
 * @param value the text
 * @param typed NaN if the text is no number
 * @param used as the field shows it
 */
export function refusal(label: string, range: string, value: string, typed: number, used: string): string {
	if (!Number.isFinite(typed)) return text("refused_text", { value: value.slice(0, 20), label, used });
	return text("refused_number", { label, typed: String(typed), used, range });
}

/** Returns the name of the field beside a slider: "Length in millimetres". */
export const typedName = (label: string, unit: string): string =>
	unit ? text("typed_field_in", { label, unit: spoken(unit) }) : text("typed_field", { label });

/** Returns whether a key on a slider belongs to the field beside it: Enter, or a character that begins a number. */
export function isForField({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
	return !ctrlKey && !metaKey && !altKey && (key === "Enter" || /^[-−.,\d]$/.test(key));
}

/** Moves the focus to the field; a typed character replaces its content. */
export function handOver(event: KeyboardEvent, field: HTMLInputElement | null): void {
	if (event.key === "Enter") event.preventDefault();
	field?.focus();
	field?.select();
}

/**
 * Handles a key in the text field: Enter accepts the text, Escape discards it, and both move the focus back to the
 * slider.
 */
export function handBack(event: KeyboardEvent, value: number | string, slider: HTMLInputElement | null): void {
	if (event.key !== "Enter" && event.key !== "Escape") return;
	event.preventDefault();
	if (event.key === "Escape") (event.target as HTMLInputElement).value = String(value);
	slider?.focus();
}
