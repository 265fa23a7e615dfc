/** What a page holds at rest, and whether it grows with use. */
import { grown } from "../bench/steady.mjs";

/** @typedef {{ heap: number, nodes: number, listeners: number, workers: number }} Held the heap in MB, and counts */

/** Samples, without those of the start, from which on growth can be told from chance. */
const FEWEST_SAMPLES = 6;
/** Added to each number before a tenth more counts as growth, so that small numbers may differ. @type {Held} */
const GIVE = { heap: 20, nodes: 5000, listeners: 1000, workers: 5 };

/**
 * What of a page grows with its use.
 *
 * @param {readonly Held[]} samples of one page between two loads
 * @returns {string[]} keys of `Held`
 */
export function growing(samples) {
	// What is fetched at first, models and pictures, is no growth with use.
	const settled = samples.slice(Math.ceil(samples.length / 3));
	if (settled.length < FEWEST_SAMPLES) return [];
	return Object.keys(GIVE).filter((key) => grown(settled.map((each) => each[key] + GIVE[key])));
}
