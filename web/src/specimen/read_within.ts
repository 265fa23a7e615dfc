/** Reads a number that has a range, with a note for one that does not fit. */
import { type Notes, quote } from "./notes";
import { readNumber } from "./read_values";
import { inGap, nearestWithin, type ValueRange } from "./table";

/**
 * The number, moved into the range with a note where it does not fit; undefined where there is none.
 * @param before the value that is used where it is no number, in the words of the note
 */
export function readWithin(
	range: ValueRange,
	key: string,
	value: unknown,
	before: unknown,
	notes: Notes,
): number | undefined {
	const number = readNumber(value);
	if (number === undefined) {
		notes.add(key, `${quote(value)} is not a number`, `${before} is used`);
		return undefined;
	}
	const used = nearestWithin(range, number);
	const problem = misfit(range, number);
	if (problem) notes.add(key, problem, `${used} is used`);
	return used;
}

function misfit(range: ValueRange, number: number): string | undefined {
	const { kind, min, max, gapBelow } = range;
	if (number < min) return `${number} is below the least value, ${min}`;
	if (number > max) return `${number} is above the greatest value, ${max}`;
	if (kind === "integer" && !Number.isInteger(number)) return `${number} is not a whole number`;
	return inGap(range, number) ? `${number} lies between 0 and ${gapBelow}, where nothing is` : undefined;
}
