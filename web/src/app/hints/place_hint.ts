/** Places a hint near its target, where it covers no control. All lengths are CSS pixels. */

export interface ScreenBox {
	readonly left: number;
	readonly top: number;
	readonly width: number;
	readonly height: number;
}

interface Size {
	readonly width: number;
	readonly height: number;
}

interface Place {
	readonly left: number;
	readonly top: number;
}

/** Least distance of a hint to controls and to the edges of its area. */
const GAP = 8;
/** Distance between the places that are tried. */
const STEP = 8;

export interface Surroundings {
	/** The element that the hint is about. */
	readonly target: ScreenBox;
	/** The area in which the hint must be. */
	readonly bounds: ScreenBox;
	/** Elements that the hint must not cover. */
	readonly controls: readonly ScreenBox[];
	/** Elements that the hint covers only where there is no other place. */
	readonly others: readonly ScreenBox[];
}

/** Returns the free place that is nearest to the target; undefined if there is none. */
export function placeHint(size: Size, { target, bounds, controls, others }: Surroundings): Place | undefined {
	const hard = [target, ...controls].filter((box) => overlap(box, bounds, 0));
	const soft = others.filter((box) => overlap(box, bounds, 0));
	return nearestFree(size, target, bounds, [...hard, ...soft]) ?? nearestFree(size, target, bounds, hard);
}

/** Returns whether a hint at a place is within the area and covers no control and no other element. */
export function isFree(size: Size, place: Place, { target, bounds, controls, others }: Surroundings): boolean {
	const hint = { ...place, ...size };
	return isWithin(hint, bounds) && ![target, ...controls, ...others].some((box) => overlap(box, hint, 0));
}

/**
 * Returns the place nearest to the target at which a hint covers none of the boxes in `taken`; undefined if there is
 * none.
 */
function nearestFree(size: Size, target: ScreenBox, bounds: ScreenBox, taken: readonly ScreenBox[]): Place | undefined {
	let nearest: Place | undefined;
	let least = Number.POSITIVE_INFINITY;
	for (const top of stepsWithin(bounds.top, bounds.height, size.height))
		for (const left of stepsWithin(bounds.left, bounds.width, size.width)) {
			const hint = { left, top, ...size };
			const distance = distanceBetween(hint, target);
			if (distance >= least || taken.some((box) => overlap(box, hint, GAP))) continue;
			least = distance;
			nearest = { left, top };
		}
	return nearest;
}

/**
 * Returns the places along one side of the area, both ends included; none if the hint is longer than the area.
 * @param own length of the hint along that side
 */
function stepsWithin(start: number, length: number, own: number): readonly number[] {
	const [first, last] = [start + GAP, start + length - GAP - own];
	if (last < first) return [];
	const count = Math.ceil((last - first) / STEP);
	return Array.from({ length: count + 1 }, (_, step) => Math.min(first + step * STEP, last));
}

/** Returns whether two boxes overlap or are nearer than `gap`. */
const overlap = (a: ScreenBox, b: ScreenBox, gap: number): boolean =>
	a.left < b.left + b.width + gap &&
	b.left < a.left + a.width + gap &&
	a.top < b.top + b.height + gap &&
	b.top < a.top + a.height + gap;

/** Returns whether a box is within the bounds. */
const isWithin = (box: ScreenBox, bounds: ScreenBox): boolean =>
	box.left >= bounds.left &&
	box.top >= bounds.top &&
	box.left + box.width <= bounds.left + bounds.width &&
	box.top + box.height <= bounds.top + bounds.height;

/**
 * Returns the distance between the edges of two boxes, plus a small share of the distance of their centres, so that
 * boxes at equal distances have an order.
 */
function distanceBetween(a: ScreenBox, b: ScreenBox): number {
	const apart = (start: number, length: number, other: number, otherLength: number) =>
		Math.max(0, other - start - length, start - other - otherLength);
	const edges = Math.hypot(apart(a.left, a.width, b.left, b.width), apart(a.top, a.height, b.top, b.height));
	const centres = Math.hypot(a.left + a.width / 2 - b.left - b.width / 2, a.top + a.height / 2 - b.top - b.height / 2);
	return edges + centres / 100;
}
