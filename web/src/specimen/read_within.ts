/** Reads a number that has a range, with a note for one that does not fit. */
import type { Message } from "../locale/texts";
import { text } from "./messages.generated";
import { type Notes, quote } from "./notes";
import { readNumber } from "./read_values";
import { inGap, nearestWithin, type ValueRange } from "./table";

/**
 * Returns the number, moved into the range with a note where it does not fit; undefined where there is none.
 * @param otherwise a sentence on the value that is used where it is no number
 */
export function readWithin(
	range: ValueRange,
	key: string,
	value: unknown,
	otherwise: string,
	notes: Notes,
): number | undefined {
	const number = readNumber(value);
	if (number === undefined) {
		notes.add(key, text.message("not_a_number", { value: quote(value) }), otherwise);
		return undefined;
	}
	const used = nearestWithin(range, number);
	const problem = misfit(range, number);
	if (problem) notes.add(key, problem, text("used", { value: String(used) }));
	return used;
}

/** Returns the problem of a number outside a range, or not on its steps; undefined if it fits. */
function misfit(range: ValueRange, number: number): Message | undefined {
	const { kind, min, max, gapBelow } = range;
	const value = String(number);
	if (number < min) return text.message("below_minimum", { value, least: String(min) });
	if (number > max) return text.message("above_maximum", { value, most: String(max) });
	if (kind === "integer" && !Number.isInteger(number)) return text.message("not_a_whole_number", { value });
	return inGap(range, number) ? text.message("in_gap", { value, least: String(gapBelow) }) : undefined;
}
