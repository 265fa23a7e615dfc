/** Resources that a page holds at rest, and whether they grow with use. */
import { grown } from "../bench/steady.mjs";

/** @typedef {{ heap: number, nodes: number, listeners: number, workers: number }} Held the heap in MB, and counts */

/** Least number of samples, without the first ones, that distinguish growth from noise. */
const FEWEST_SAMPLES = 6;
/** Added to each number before a tenth more counts as growth, so that small numbers may differ. @type {Held} */
const GIVE = { heap: 20, nodes: 5000, listeners: 1000, workers: 5 };

/**
 * Resources of a page that grow with its use.
 *
 * @param {readonly Held[]} samples of one page between two loads
 * @returns {string[]} keys of `Held`
 */
export function growing(samples) {
	// The first samples are skipped: loading models and pictures is not growth with use.
	const settled = samples.slice(Math.ceil(samples.length / 3));
	if (settled.length < FEWEST_SAMPLES) return [];
	return Object.keys(GIVE).filter((key) => grown(settled.map((each) => each[key] + GIVE[key])));
}
