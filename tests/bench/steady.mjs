/** Whether a series of measurements goes up. */
import { median } from "./statistics.mjs";

/** Tolerance of the end above the beginning: garbage varies. */
const GIVE = 0.1;

/**
 * Whether the last third of a series lies more than a tenth above the first, in medians.
 * @param {number[]} series
 */
export function grown(series) {
	const third = Math.ceil(series.length / 3);
	return median(series.slice(-third)) > (1 + GIVE) * median(series.slice(0, third));
}
