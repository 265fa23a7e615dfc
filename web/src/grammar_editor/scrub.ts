/** Step sizes and text of numbers that are dragged in the editor. */
import { decimals, type NumberAt } from "./outline";

/** Pixels of a drag per step. */
export const PIXELS_A_STEP = 4;

/** Factor of a step for modifier keys: 10 with Shift, 0.1 with Ctrl or Command. */
export function reach({ shiftKey, ctrlKey, metaKey }: Pick<MouseEvent, "shiftKey" | "ctrlKey" | "metaKey">): number {
	if (shiftKey) return 10;
	return ctrlKey || metaKey ? 0.1 : 1;
}

/** Returns the step of a number: one unit of its last digit. */
export function stepOf({ text }: Pick<NumberAt, "text">): number {
	return 10 ** -decimals(text);
}

/**
 * Adds steps to a number and formats it with as many digits as before, or one more for fractional steps.
 * @param steps rounded to tenths
 */
export function stepped({ text, value }: Pick<NumberAt, "text" | "value">, steps: number): string {
	const places = decimals(text);
	const tenths = Math.round(steps * 10);
	const finer = tenths % 10 !== 0;
	const moved = value + (tenths / 10) * 10 ** -places;
	return written(moved, places + (finer ? 1 : 0));
}

/** Formats a number with a number of decimals. */
export function written(value: number, places: number): string {
	const text = value.toFixed(Math.min(places, 12));
	// −0 is 0.
	return Number(text) === 0 ? text.replace("-", "") : text;
}
