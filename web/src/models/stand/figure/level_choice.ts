/** Which level of detail a plant is shown at: by how large it is in the view, and by how much may be drawn in all. */

/** From so large on, as a share of the view's height, each level is shown; the last from nothing on. */
const FROM = [0.75, 0.26, 0.085];
/** Over so wide a band, as a share, a level gives way to the next. */
const BAND = 0.2;
/** Shares of the two are told in so many steps. */
const STEPS = 16;

/** What is shown: `level` by its share, and where that is less than 1 the next one by the rest. */
export interface Shown {
	readonly level: number;
	/** In (0, 1]. */
	readonly share: number;
}

/**
 * @param size of the plant in the view, as a share of the view's height
 * @param levels how many there are
 * @param first the finest that may be shown
 */
export function shownAt(size: number, levels: number, first = 0): Shown {
	for (let level = first; level + 1 < levels; level++) {
		const from = FROM[Math.min(level, FROM.length - 1)] ?? 0;
		if (size < from) continue;
		const share = Math.ceil((STEPS * (size - from)) / (BAND * from)) / STEPS;
		return share > 0 ? { level, share: Math.min(1, share) } : { level: level + 1, share: 1 };
	}
	return { level: levels - 1, share: 1 };
}
