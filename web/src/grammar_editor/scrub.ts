/** Step sizes and text of numbers that are dragged in the editor. */
import { decimals, type NumberAt } from "./outline";

/** Pixels of a drag to one step. */
export const PIXELS_A_STEP = 4;

/** Factor of a step for modifier keys: 10 with Shift, 0.1 with Ctrl or Command. */
export function reach({ shiftKey, ctrlKey, metaKey }: Pick<MouseEvent, "shiftKey" | "ctrlKey" | "metaKey">): number {
	if (shiftKey) return 10;
	return ctrlKey || metaKey ? 0.1 : 1;
}

/** One step of a number: one of its last digit. */
export function stepOf({ text }: Pick<NumberAt, "text">): number {
	return 10 ** -decimals(text);
}

/**
 * A number some steps on, as it is to be written: with as many digits as before, and more where the steps are finer.
 *
 * @param steps may be a fraction: it is taken to tenths
 */
export function stepped({ text, value }: Pick<NumberAt, "text" | "value">, steps: number): string {
	const places = decimals(text);
	const tenths = Math.round(steps * 10);
	const finer = tenths % 10 !== 0;
	const moved = value + (tenths / 10) * 10 ** -places;
	return written(moved, places + (finer ? 1 : 0));
}

/** A number with so many digits behind the point. */
export function written(value: number, places: number): string {
	const text = value.toFixed(Math.min(places, 12));
	// −0 is 0.
	return Number(text) === 0 ? text.replace("-", "") : text;
}
