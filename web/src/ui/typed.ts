/** Typed numbers: the field beside a slider. It is no stop of the Tab key; keys on the slider move the focus to it. */

/** Reads a number as people type it: with a decimal comma, or a typographic minus; NaN if it is no number. */
export function readTyped(text: string): number {
	const plain = text.trim().replace(",", ".").replace("−", "-");
	return plain === "" ? Number.NaN : Number(plain);
}

/**
 * Returns a message if the number accepted differs from the typed text.
 * @param range "1 … 21."
 * @param typed NaN if the text is no number
 * @param taken as the field shows it
 */
export function refusal(label: string, range: string, text: string, typed: number, taken: string): string {
	if (!Number.isFinite(typed)) return `“${text.slice(0, 20)}” is not a number; ${label} stays ${taken}.`;
	return `${label} takes ${range} ${typed} became ${taken}.`;
}

/** Whether a key on a slider belongs to the field beside it: Enter, or a character that begins a number. */
export function isForField({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
	return !ctrlKey && !metaKey && !altKey && (key === "Enter" || /^[-−.,\d]$/.test(key));
}

/** Moves the focus to the field; a typed character replaces its content. */
export function handOver(event: KeyboardEvent, field: HTMLInputElement | null): void {
	if (event.key === "Enter") event.preventDefault();
	field?.focus();
	field?.select();
}

/** In the field, Enter accepts the text, Escape discards it, and both move the focus back to the slider. */
export function handBack(event: KeyboardEvent, value: number | string, slider: HTMLInputElement | null): void {
	if (event.key !== "Enter" && event.key !== "Escape") return;
	event.preventDefault();
	if (event.key === "Escape") (event.target as HTMLInputElement).value = String(value);
	slider?.focus();
}
