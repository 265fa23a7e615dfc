/** A position in a flat view: in its own units for handles, in CSS pixels for pointers. */
export interface Point {
	readonly x: number;
	readonly y: number;
}

/**
 * Returns the item nearest to a pointer; undefined if none is within reach. Hit areas of close handles overlap, so that
 * the topmost button need not be the nearest.
 */
export function nearest<H>(places: Iterable<readonly [H, Point]>, pointer: Point, reach: number): H | undefined {
	let found: H | undefined;
	let least = reach;
	for (const [handle, { x, y }] of places) {
		const distance = Math.hypot(x - pointer.x, y - pointer.y);
		if (!(distance <= least)) continue;
		least = distance;
		found = handle;
	}
	return found;
}

/** Arrow keys as steps: x to the right, y up. */
export const ARROWS: Readonly<Record<string, Point>> = {
	ArrowLeft: { x: -1, y: 0 },
	ArrowRight: { x: 1, y: 0 },
	ArrowUp: { x: 0, y: 1 },
	ArrowDown: { x: 0, y: -1 },
};
