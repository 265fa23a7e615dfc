/** The numbers of a series' plants in the form of `--seeds`: `1-100`, `7`, `1-10,20,33-35`. */
import { SEED } from "../specimen/limits";
import { text } from "./messages.generated";
import { Unusable } from "./unusable";

/** The most plants of one series: spreadsheets still open its table. */
export const MAX_PLANTS = 100_000;

/**
 * Reads the numbers, each once, in the order of the text.
 * @throws Unusable
 */
export function readPlantNumbers(written: string): number[] {
	const numbers = new Set<number>();
	for (const part of written.split(",")) {
		const [, first, last = first] = /^\s*(\d+)\s*(?:-\s*(\d+)\s*)?$/.exec(part) ?? [];
		if (first === undefined) throw new Unusable(text.message("numbers_unreadable", { part: part.trim() }));
		addRange(numbers, Number(first), Number(last));
	}
	return [...numbers];
}

/**
 * Adds the numbers `first` … `last`.
 * @throws Unusable if the range is backwards or reaches beyond the largest seed, or if the series gets too long
 */
function addRange(numbers: Set<number>, first: number, last: number): void {
	if (last > SEED.max) throw new Unusable(text.message("number_too_large", { number: `${last}`, max: `${SEED.max}` }));
	if (first > last) {
		const range = { range: `${first}-${last}`, corrected: `${last}-${first}` };
		throw new Unusable(text.message("range_backwards", range));
	}
	for (let number = first; number <= last; number++) {
		numbers.add(number);
		if (numbers.size > MAX_PLANTS) {
			throw new Unusable(text.message("too_many_plants", { max: MAX_PLANTS }));
		}
	}
}
