/** Edits a curve's points by dragging. Pure functions; the points stay in order from left to right. */
import { written } from "./scrub";

export type CurvePoint = readonly [x: number, y: number];

/** Range in which the points of a curve may be drawn: their extent, with a margin above and below. */
export interface CurveFrame {
	readonly left: number;
	readonly right: number;
	readonly low: number;
	readonly high: number;
}

/** Least number of points. */
const FEWEST = 2;
/** Least distance of neighbours, as a share of the frame's width. */
const APART = 0.01;

/** Returns the frame of a curve, at least 0 … 1 in both directions. */
export function frameOf(points: readonly CurvePoint[]): CurveFrame {
	const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
	const [low, high] = [Math.min(0, ...ys), Math.max(1, ...ys)];
	return { left: Math.min(0, ...xs), right: Math.max(1, ...xs), low, high };
}

/**
 * Moves the point of an index, limited by its neighbours and the frame.
 * @param moving index of the point
 */
export function moved(
	points: readonly CurvePoint[],
	moving: number,
	[x, y]: CurvePoint,
	{ left, right, low, high }: CurveFrame,
): CurvePoint[] {
	const gap = (right - left) * APART;
	const leftLimit = moving > 0 ? points[moving - 1][0] + gap : left;
	const rightLimit = moving < points.length - 1 ? points[moving + 1][0] - gap : right;
	const newPoint = [clamp(x, leftLimit, Math.max(leftLimit, rightLimit)), clamp(y, low, high)] as const;
	return points.map((point, index) => (index === moving ? newPoint : point));
}

/** Adds a point in order; returns the same list if there is already a point at that place. */
export function added(points: readonly CurvePoint[], [x, y]: CurvePoint, frame: CurveFrame): readonly CurvePoint[] {
	const gap = (frame.right - frame.left) * APART;
	if (x < frame.left || x > frame.right || points.some(([other]) => Math.abs(other - x) < gap)) return points;
	const at = points.findIndex(([other]) => other > x);
	return points.toSpliced(at < 0 ? points.length : at, 0, [x, clamp(y, frame.low, frame.high)]);
}

/**
 * Removes the point of an index; returns the same list if too few points would remain.
 * @param index of the point
 */
export function removed(points: readonly CurvePoint[], index: number): readonly CurvePoint[] {
	return points.length > FEWEST ? points.toSpliced(index, 1) : points;
}

/** Formats points as in a text: `(0, 0) (0.3, 1)`, rounded to 0.01, or to 0.001 in a narrow frame. */
export function inText(points: readonly CurvePoint[], { left, right, low, high }: CurveFrame): string {
	const places = (width: number) => Math.max(0, 2 - Math.floor(Math.log10(width)));
	const number = (value: number, width: number) => String(Number(written(value, places(width))));
	return points.map(([x, y]) => `(${number(x, right - left)}, ${number(y, high - low)})`).join(" ");
}

/**
 * Returns the curve's value by monotone cubic interpolation of the points (Fritsch and Carlson 1980), constant beyond
 * the ends, without overshoot; the same as the core's. Between two points it is the cubic Hermite polynomial.
 */
export function valueAt(points: readonly CurvePoint[], x: number): number {
	const last = points.length - 1;
	if (x <= points[0][0]) return points[0][1];
	if (x >= points[last][0]) return points[last][1];
	const before = points.findIndex(([next]) => next > x) - 1;
	const [[x0, y0], [x1, y1]] = [points[before], points[before + 1]];
	const width = x1 - x0;
	const t = (x - x0) / width;
	const [m0, m1] = [tangent(points, before), tangent(points, before + 1)];
	const t2 = t * t;
	const t3 = t2 * t;
	return (2 * t3 - 3 * t2 + 1) * y0 + (t3 - 2 * t2 + t) * width * m0 + (3 * t2 - 2 * t3) * y1 + (t3 - t2) * width * m1;
}

/**
 * Returns the slope of the curve at a point: the harmonic mean of the adjacent slopes, weighted by widths; 0 where the
 * slopes change sign; the adjacent slope at the ends.
 * @param index of the point
 */
function tangent(points: readonly CurvePoint[], index: number): number {
	const slope = (from: number) => (points[from + 1][1] - points[from][1]) / (points[from + 1][0] - points[from][0]);
	if (index === 0) return slope(0);
	if (index === points.length - 1) return slope(index - 1);
	const [before, after] = [slope(index - 1), slope(index)];
	if (before * after <= 0) return 0;
	const [h0, h1] = [points[index][0] - points[index - 1][0], points[index + 1][0] - points[index][0]];
	const [w0, w1] = [2 * h1 + h0, h1 + 2 * h0];
	return (w0 + w1) / (w0 / before + w1 / after);
}

/** Limits a value to a range. */
function clamp(value: number, least: number, most: number): number {
	return Math.min(Math.max(value, least), most);
}
