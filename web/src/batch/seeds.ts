/** The seeds of a series, as a person writes them: `1-100`, `7`, `1-10,20,33-35`. */
import { SEED } from "../specimen/limits";
import { Unusable } from "./unusable";

/** Plants of one series at the most: its table is still one that spreadsheets open. */
export const MOST_PLANTS = 100_000;

/**
 * Each seed once, in the order in which they are written.
 * @throws Unusable
 */
export function readSeeds(text: string): number[] {
	const seeds = new Set<number>();
	for (const part of text.split(",")) {
		const [, first, last = first] = /^\s*(\d+)\s*(?:-\s*(\d+)\s*)?$/.exec(part) ?? [];
		if (first === undefined)
			throw new Unusable(`“${part.trim()}” is no seed and no range of them; write 1-100 or 1,5,9`);
		addRange(seeds, Number(first), Number(last));
	}
	return [...seeds];
}

function addRange(seeds: Set<number>, first: number, last: number): void {
	if (last > SEED.max) throw new Unusable(`${last} is above the greatest seed, ${SEED.max}`);
	if (first > last) throw new Unusable(`${first}-${last} runs backwards; write ${last}-${first}`);
	for (let seed = first; seed <= last; seed++) {
		seeds.add(seed);
		if (seeds.size > MOST_PLANTS) {
			throw new Unusable(`more than ${MOST_PLANTS} plants; write several series, each into a folder of its own`);
		}
	}
}
