/** Chooses a plant's level of detail by its size in the view. */

/** Least size of each level, as a share of the view's height; the last level has no limit. */
export const LEAST_SIZES: readonly number[] = [0.75, 0.26, 0.085];
/** Range of sizes over which a level fades to the next, as a share of its least size. */
const BAND = 0.2;
/** Steps of fading between two levels. */
export const STEPS = 16;

/**
 * Returns the step of a plant: `STEPS` × level + the step of fading to the next level. A single number, because it is
 * computed for thousands of plants per frame.
 * @param size size in the view, as a share of the view's height
 * @param levels number of levels
 * @param leastSizes least size of each level but the last
 */
export function stepAt(size: number, levels: number, leastSizes = LEAST_SIZES): number {
	for (let level = 0; level + 1 < levels; level++) {
		const leastSize = leastSizes[Math.min(level, leastSizes.length - 1)];
		if (size < leastSize) continue;
		const remaining = Math.ceil((STEPS * (size - leastSize)) / (BAND * leastSize));
		return STEPS * level + STEPS - Math.min(STEPS, remaining);
	}
	return STEPS * (levels - 1);
}
