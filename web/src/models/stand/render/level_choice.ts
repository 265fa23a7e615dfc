/** Which level of detail a plant is shown at: by how large it is in the view, and by how much may be drawn in all. */

/** From so large on, as a share of the view's height, each level is shown; the last from nothing on. */
const FROM = [0.75, 0.26, 0.085];
/** Over so wide a band, as a share, a level gives way to the next. */
const BAND = 0.2;
/** From a level to the next in so many steps: so many shares of the two there are. */
export const STEPS = 16;

/**
 * How far from the finest level on: `STEPS` times a level, and in between the parts of `STEPS` by which it has given way to the next. One
 * number, for it is asked of thousands of plants a frame.
 * @param size of the plant in the view, as a share of the view's height
 * @param levels how many there are
 */
export function stepAt(size: number, levels: number): number {
	for (let level = 0; level + 1 < levels; level++) {
		const from = FROM[Math.min(level, FROM.length - 1)];
		if (size < from) continue;
		const remaining = Math.ceil((STEPS * (size - from)) / (BAND * from));
		return STEPS * level + STEPS - Math.min(STEPS, remaining);
	}
	return STEPS * (levels - 1);
}
