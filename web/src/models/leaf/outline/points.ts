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
export const MOST_POINTS = 64;

/** Whether both sides move together. */
export interface Symmetry {
	mirror: boolean;
}

/** A position in leaf lengths, y to the tip. */
export type Place = Point;

/** The nearest allowed position. */
export function placed({ x, y }: Place): Place {
	return { x: within(x, REACH.x), y: within(y, REACH.y) };
}

function within(value: number, [low, high]: readonly [number, number]): number {
	return Math.round(Math.min(high, Math.max(low, value)) / STEP) / Math.round(1 / STEP) + 0; // −0 becomes 0
}

/** Index of the mirror point; the base and a tip on the midrib are their own mirror points. */
export function mirrorOf(index: number, count: number): number {
	return (count - index) % count;
}

/** The mirror image of a point. */
export function mirrored({ x, y, kind }: OutlinePoint): OutlinePoint {
	return { x: 0 - x, y, kind }; // never −0
}

/**
 * Both sides of a leaf from its right side.
 * @param half from the base to the tip; a last point beside the midrib is mirrored too
 */
export function bothSides(half: OutlinePoints): OutlinePoint[] {
	const turned = half.at(-1)?.x === 0 ? half.slice(1, -1) : half.slice(1); // the base is its own mirror point
	return [...half, ...turned.map(mirrored).reverse()];
}

/** The right side, from the base to the tip. */
export function rightSide(points: OutlinePoints): OutlinePoints {
	return points.slice(0, Math.floor(points.length / 2) + 1);
}

/** Whether the left side mirrors the right one. */
export function isSymmetric(points: OutlinePoints): boolean {
	return points.every((point, index) => {
		const other = points[mirrorOf(index, points.length)];
		return other.x === 0 - point.x && other.y === point.y && other.kind === point.kind;
	});
}

/** Mirrors the right side to the left; the right side ends at the highest point, which moves to the midrib. */
export function madeSymmetric(points: OutlinePoints): OutlinePoint[] {
	if (isSymmetric(points)) return [...points];
	const top = points.reduce((best, { y }, index) => (index > 0 && y > points[best].y ? index : best), 1);
	const half = points.slice(0, top + 1).map((point) => ({ ...point, x: Math.max(0, point.x) }));
	half[top] = { ...half[top], x: 0 };
	const both = bothSides(half);
	return both.length < FEWEST_POINTS || both.length > MOST_POINTS ? [...points] : both;
}

/** Moves a point; the base stays. */
export function movePoint(points: OutlinePoints, index: number, to: Place, { mirror }: Symmetry): OutlinePoint[] {
	if (index === 0) return [...points];
	const other = mirrorOf(index, points.length);
	const { x, y } = placed(mirror && other === index ? { x: 0, y: to.y } : to);
	return points.map((point, at) => {
		if (at === index) return { ...point, x, y };
		return mirror && at === other ? { ...point, x: 0 - x, y } : point;
	});
}

/** Inserts a smooth point after another; no change where there would be too many. */
export function insertPoint(points: OutlinePoints, after: number, at: Place, { mirror }: Symmetry): OutlinePoint[] {
	const { length } = points;
	const opposite = mirrorOf(after + 1, length);
	const alone = !mirror || opposite === after;
	if (length + (alone ? 1 : 2) > MOST_POINTS) return [...points];
	const { x, y } = placed(mirror && alone ? { x: 0, y: at.y } : at);
	const next: OutlinePoint = { x, y, kind: "smooth" };
	return points.flatMap((point, index) => {
		if (index === after) return [point, next];
		return !alone && index === opposite ? [point, mirrored(next)] : [point];
	});
}

/** Index of a point that was inserted after another. */
export function insertedAt(count: number, after: number, { mirror }: Symmetry): number {
	return after + 1 + (mirror && mirrorOf(after + 1, count) < after ? 1 : 0);
}

/** Removes a point; the base and the last `FEWEST_POINTS` stay. */
export function removePoint(points: OutlinePoints, index: number, { mirror }: Symmetry): OutlinePoint[] {
	const gone = new Set(mirror ? [index, mirrorOf(index, points.length)] : [index]);
	if (index === 0 || points.length - gone.size < FEWEST_POINTS) return [...points];
	return points.filter((_, at) => !gone.has(at));
}

/** Changes a point to the next kind. */
export function turnKind(points: OutlinePoints, index: number, { mirror }: Symmetry): OutlinePoint[] {
	const kind = KINDS[(KINDS.indexOf(points[index].kind) + 1) % KINDS.length];
	const turned = new Set(mirror ? [index, mirrorOf(index, points.length)] : [index]);
	return points.map((point, at) => (turned.has(at) ? { ...point, kind } : point));
}

/** Twice the signed area, positive where the loop runs counter-clockwise. */
export function doubleArea(points: readonly Place[]): number {
	return points.reduce((sum, { x, y }, index) => {
		const next = points[(index + 1) % points.length];
		return sum + x * next.y - next.x * y;
	}, 0);
}
