/** Chooses the names of stages that have room below a slider. Pure. */

/** The range of a name along the slider, CSS pixels. */
export interface NameRange {
	readonly start: number;
	readonly end: number;
}

/** Least distance between two names. */
const GAP = 4;

/**
 * Returns for each name whether it has room: the current one always, the others from the first on if they do not touch
 * one that is shown.
 * @param current index of the current name; −1 if there is none
 */
export function namesWithRoom(names: readonly NameRange[], current: number): readonly boolean[] {
	const shown: NameRange[] = names[current] ? [names[current]] : [];
	return names.map((name, index) => {
		if (index === current) return true;
		const touches = shown.some(({ start, end }) => name.start < end + GAP && start < name.end + GAP);
		if (!touches) shown.push(name);
		return !touches;
	});
}
