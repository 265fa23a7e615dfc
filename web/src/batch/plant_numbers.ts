/** The numbers of a series' plants in the form of `--seeds`: `1-100`, `7`, `1-10,20,33-35`. */
import { SEED } from "../specimen/limits";
import { Unusable } from "./unusable";

/** The most plants of one series: spreadsheets still open its table. */
export const MOST_PLANTS = 100_000;

/**
 * Each number once, in the order of the text.
 * @throws Unusable
 */
export function readPlantNumbers(text: string): number[] {
	const numbers = new Set<number>();
	for (const part of text.split(",")) {
		const [, first, last = first] = /^\s*(\d+)\s*(?:-\s*(\d+)\s*)?$/.exec(part) ?? [];
		if (first === undefined)
			throw new Unusable(`“${part.trim()}” is not a number or a range of numbers; write 1-100 or 1,5,9`);
		addRange(numbers, Number(first), Number(last));
	}
	return [...numbers];
}

function addRange(numbers: Set<number>, first: number, last: number): void {
	if (last > SEED.max) throw new Unusable(`${last} is above the greatest number, ${SEED.max}`);
	if (first > last) throw new Unusable(`${first}-${last} runs backwards; write ${last}-${first}`);
	for (let number = first; number <= last; number++) {
		numbers.add(number);
		if (numbers.size > MOST_PLANTS) {
			throw new Unusable(`more than ${MOST_PLANTS} plants; write several series, each into a folder of its own`);
		}
	}
}
