/**
 * Control points of a blade's outline, and edits as pure functions that return a new list. Seen with the tip up, the
 * loop runs counter-clockwise from the base at the petiole: point 0, always at (0, 0). Coordinates are in leaf
 * lengths, x to the right, y to the tip, which is at about (0, 1).
 */
import type { Point } from "../../../ui/handles/point";

/** Kinds of points: smooth, an angle, or the rounded or pointed tip of a lobe, to which a main vein runs. */
export const KINDS = ["smooth", "corner", "lobe", "pointed"] as const;
export type LeafKind = (typeof KINDS)[number];

export interface OutlinePoint {
	x: number;
	y: number;
	kind: LeafKind;
}
export type OutlinePoints = readonly OutlinePoint[];

/** Ranges of coordinates; links store them in steps of `STEP`. */
export const REACH = { x: [-1.023, 1.023], y: [-0.5, 1.547] } as const;
export const STEP = 0.001;
export const FEWEST_POINTS = 3;
export const MAX_POINTS = 64;

/** Whether both sides move together. */
export interface Symmetry {
	mirror: boolean;
}

/** A position in leaf lengths, y to the tip. */
export type Place = Point;

/** Returns the nearest allowed position: within REACH, in whole STEPs. */
export function placed({ x, y }: Place): Place {
	return { x: limitedToRange(x, REACH.x), y: limitedToRange(y, REACH.y) };
}

/** Limits a coordinate to a range and rounds it to a multiple of STEP. */
function limitedToRange(value: number, [low, high]: readonly [number, number]): number {
	return Math.round(Math.min(high, Math.max(low, value)) / STEP) / Math.round(1 / STEP) + 0; // −0 becomes 0
}

/**
 * Returns the index of a point's mirror point; the base and a tip on the midrib are their own mirror points.
 * @param count number of points of the outline
 */
export function mirrorOf(index: number, count: number): number {
	return (count - index) % count;
}

/** Returns the mirror image of a point at the midrib. */
export function mirrored({ x, y, kind }: OutlinePoint): OutlinePoint {
	return { x: 0 - x, y, kind }; // never −0
}

/**
 * Returns all points of a symmetric leaf from those of its right side.
 * @param half from the base to the tip; a last point beside the midrib is mirrored too
 */
export function bothSides(half: OutlinePoints): OutlinePoint[] {
	const turned = half.at(-1)?.x === 0 ? half.slice(1, -1) : half.slice(1); // the base is its own mirror point
	return [...half, ...turned.map(mirrored).reverse()];
}

/** Returns the points of the right side, from the base to the tip: the first half of the list. */
export function rightSide(points: OutlinePoints): OutlinePoints {
	return points.slice(0, Math.floor(points.length / 2) + 1);
}

/** Returns whether the left side mirrors the right one exactly. */
export function isSymmetric(points: OutlinePoints): boolean {
	return points.every((point, index) => {
		const other = points[mirrorOf(index, points.length)];
		return other.x === 0 - point.x && other.y === point.y && other.kind === point.kind;
	});
}

/**
 * Mirrors the right side to the left; the right side ends at the highest point, which moves to the midrib. The outline
 * remains unchanged where there would be too few or too many points.
 */
export function madeSymmetric(points: OutlinePoints): OutlinePoint[] {
	if (isSymmetric(points)) return [...points];
	const top = points.reduce((best, { y }, index) => (index > 0 && y > points[best].y ? index : best), 1);
	const half = points.slice(0, top + 1).map((point) => ({ ...point, x: Math.max(0, point.x) }));
	half[top] = { ...half[top], x: 0 };
	const both = bothSides(half);
	return both.length < FEWEST_POINTS || both.length > MAX_POINTS ? [...points] : both;
}

/** Moves a point, with its mirror point on a symmetric leaf; the base stays. */
export function movePoint(points: OutlinePoints, index: number, to: Place, { mirror }: Symmetry): OutlinePoint[] {
	if (index === 0) return [...points];
	const other = mirrorOf(index, points.length);
	const { x, y } = placed(mirror && other === index ? { x: 0, y: to.y } : to);
	return points.map((point, at) => {
		if (at === index) return { ...point, x, y };
		return mirror && at === other ? { ...point, x: 0 - x, y } : point;
	});
}

/**
 * Inserts a smooth point on the edge that begins at point `after`; no change where there would be too many points. On a
 * symmetric leaf, its mirror image is inserted on the mirror edge. An edge that crosses the midrib is its own mirror
 * edge: it gets a single point, on the midrib.
 */
export function insertPoint(points: OutlinePoints, after: number, at: Place, { mirror }: Symmetry): OutlinePoint[] {
	const { length } = points;
	// Edge `after` ends at point `after + 1`, so its mirror edge begins at the mirror point of that.
	const mirrorEdge = mirrorOf(after + 1, length);
	const single = !mirror || mirrorEdge === after;
	if (length + (single ? 1 : 2) > MAX_POINTS) return [...points];
	const { x, y } = placed(mirror && single ? { x: 0, y: at.y } : at);
	const inserted: OutlinePoint = { x, y, kind: "smooth" };
	return points.flatMap((point, edge) => {
		if (edge === after) return [point, inserted];
		return !single && edge === mirrorEdge ? [point, mirrored(inserted)] : [point];
	});
}

/**
 * Returns the index of a point after it was inserted behind point `after`: one more where its mirror image was inserted
 * before it.
 * @param count number of points before
 */
export function insertedAt(count: number, after: number, { mirror }: Symmetry): number {
	return after + 1 + (mirror && mirrorOf(after + 1, count) < after ? 1 : 0);
}

/** Removes a point, with its mirror point on a symmetric leaf; the base and the last `FEWEST_POINTS` stay. */
export function removePoint(points: OutlinePoints, index: number, { mirror }: Symmetry): OutlinePoint[] {
	const gone = new Set(mirror ? [index, mirrorOf(index, points.length)] : [index]);
	if (index === 0 || points.length - gone.size < FEWEST_POINTS) return [...points];
	return points.filter((_, at) => !gone.has(at));
}

/** Changes a point, with its mirror point on a symmetric leaf, to the next kind. */
export function turnKind(points: OutlinePoints, index: number, { mirror }: Symmetry): OutlinePoint[] {
	const kind = KINDS[(KINDS.indexOf(points[index].kind) + 1) % KINDS.length];
	const turned = new Set(mirror ? [index, mirrorOf(index, points.length)] : [index]);
	return points.map((point, at) => (turned.has(at) ? { ...point, kind } : point));
}

/** Returns twice the signed area of a closed polygon (shoelace formula), positive where it runs counter-clockwise. */
export function doubleArea(points: readonly Place[]): number {
	return points.reduce((sum, { x, y }, index) => {
		const next = points[(index + 1) % points.length];
		return sum + x * next.y - next.x * y;
	}, 0);
}
