/**
 * The curve through an outline's points, as in the core (wasm-core/src/models/leaf/shape/margin.hpp): a closed
 * centripetal Catmull–Rom spline (Yuksel, Schaefer and Keyser 2011) with breaks at corners and pointed tips. The
 * control point there is halfway to the other control point, or a third of the way to the next point where that is
 * sharp too.
 */
import { doubleArea, type OutlinePoint, type OutlinePoints, type Place } from "./points";

/** A cubic Bézier curve from one point to the next. */
export interface Span {
	from: Place;
	first: Place;
	second: Place;
	to: Place;
}

/** Returns whether the curve has a break at a point. */
const isSharp = ({ kind }: OutlinePoint): boolean => kind === "corner" || kind === "pointed";

/** Returns the spans of an outline, one from each point to the next. */
export function spansOf(points: OutlinePoints): Span[] {
	const { length } = points;
	return points.map((from, index) => {
		const at = (offset: number) => points[(index + offset + length) % length];
		const to = at(1);
		const [start, end] = [isSharp(from), isSharp(to)];
		if (start && end) return { from, first: interpolated(from, to, 1 / 3), second: interpolated(to, from, 1 / 3), to };
		const [fromHandle, toHandle] = [controlPoint(at(-1), from, to), controlPoint(at(2), to, from)];
		return {
			from,
			first: start ? interpolated(from, toHandle, 1 / 2) : fromHandle,
			second: end ? interpolated(to, fromHandle, 1 / 2) : toHandle,
			to,
		};
	});
}

/** Returns the curve as a closed polygon of `steps` pieces per span; it begins at point 0. */
export function curveOf(points: OutlinePoints, steps = 12): Place[] {
	return spansOf(points).flatMap((span) => Array.from({ length: steps }, (_, step) => placeOn(span, step / steps)));
}

/** Returns the point of a span (a cubic Bézier curve) at the parameter t, 0 … 1. */
export function placeOn({ from, first, second, to }: Span, t: number): Place {
	const s = 1 - t;
	const [a, b, c, d] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
	return {
		x: a * from.x + b * first.x + c * second.x + d * to.x,
		y: a * from.y + b * first.y + c * second.y + d * to.y,
	};
}

/**
 * Returns the index of the span nearest to a position, and its distance in leaf lengths.
 * @param steps pieces of each span among which the nearest is searched
 */
export function nearestSpan(points: OutlinePoints, { x, y }: Place, steps = 12): { span: number; distance: number } {
	const distances = curveOf(points, steps).map((place) => Math.hypot(place.x - x, place.y - y));
	const nearest = distances.indexOf(Math.min(...distances));
	const before = distances[(nearest + distances.length - 1) % distances.length];
	const after = distances[(nearest + 1) % distances.length];
	// At a control point, the nearer neighbour decides on which side of it the position is.
	const span = nearest % steps === 0 && before < after ? nearest / steps - 1 : Math.floor(nearest / steps);
	return { span: (span + points.length) % points.length, distance: distances[nearest] };
}

/**
 * Returns the Bézier control point beside the point `at`, towards its neighbour `to`; `before` is the other neighbour.
 * Centripetal: weighted by the square roots of the distances.
 */
function controlPoint(before: Place, at: Place, to: Place): Place {
	const rootBefore = Math.sqrt(Math.hypot(at.x - before.x, at.y - before.y));
	const rootAfter = Math.sqrt(Math.hypot(to.x - at.x, to.y - at.y));
	if (rootBefore === 0 || rootAfter === 0) return interpolated(at, to, 1 / 3);
	const coordinate = (axis: "x" | "y") =>
		(rootBefore * rootBefore * to[axis] -
			rootAfter * rootAfter * before[axis] +
			(2 * rootBefore * rootBefore + 3 * rootBefore * rootAfter + rootAfter * rootAfter) * at[axis]) /
		(3 * rootBefore * (rootBefore + rootAfter));
	return { x: coordinate("x"), y: coordinate("y") };
}

/**
 * Approximate length of a piece of the core's margin, in leaf lengths, and the range of the number of pieces per span.
 */
const PIECE = 0.015;
const PIECES = { fewest: 2, most: 32 } as const;

/** Returns the curve as the core's polygon, so that page and core agree on outlines that cross themselves. */
function corePolygon(points: OutlinePoints): Place[] {
	return spansOf(points).flatMap((span) => {
		const exact = Math.ceil(Math.hypot(span.to.x - span.from.x, span.to.y - span.from.y) / PIECE);
		const pieces = Math.min(PIECES.most, Math.max(PIECES.fewest, exact));
		return Array.from({ length: pieces }, (_, piece) => placeOn(span, piece / pieces));
	});
}

/** Twice the least area of a blade, in squared leaf lengths. */
const LEAST_AREA = 0.004;

/** Returns whether points enclose a blade: counter-clockwise, with some area, without self-intersections. */
export function enclosesBlade(points: OutlinePoints): boolean {
	const curve = corePolygon(points);
	return doubleArea(curve) > LEAST_AREA && !crossesItself(curve);
}

/** Returns whether a closed polygon crosses or touches itself. */
function crossesItself(polygon: readonly Place[]): boolean {
	const { length } = polygon;
	for (let i = 0; i < length; i++) {
		const [a, b] = [polygon[i], polygon[(i + 1) % length]];
		// The last edge is adjacent to the first one.
		for (let j = i + 2; j < (i === 0 ? length - 1 : length); j++) {
			const [c, d] = [polygon[j], polygon[(j + 1) % length]];
			if (areSeparated(a, b, c, d, "x") || areSeparated(a, b, c, d, "y")) continue;
			if (sideOf(a, b, c) * sideOf(a, b, d) <= 0 && sideOf(c, d, a) * sideOf(c, d, b) <= 0) return true;
		}
	}
	return false;
}

/**
 * Returns whether the edges a b and c d do not overlap along an axis; for edges on one line no other test separates
 * them.
 */
function areSeparated(a: Place, b: Place, c: Place, d: Place, axis: "x" | "y"): boolean {
	return (
		Math.max(a[axis], b[axis]) < Math.min(c[axis], d[axis]) || Math.max(c[axis], d[axis]) < Math.min(a[axis], b[axis])
	);
}

/** Returns a number whose sign gives the side of a line on which a point is: positive on the left, 0 on the line. */
function sideOf(from: Place, to: Place, { x, y }: Place): number {
	return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
}

/** Returns the point at a share, 0 … 1, of the way from one to another. */
function interpolated(from: Place, to: Place, share: number): Place {
	return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
}
