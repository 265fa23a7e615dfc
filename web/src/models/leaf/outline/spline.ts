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

const isSharp = ({ kind }: OutlinePoint): boolean => kind === "corner" || kind === "pointed";

/** Spans of an outline: one from each point to the next. */
export function spansOf(points: OutlinePoints): Span[] {
	const { length } = points;
	return points.map((from, index) => {
		const at = (offset: number) => points[(index + offset + length) % length];
		const to = at(1);
		const [start, end] = [isSharp(from), isSharp(to)];
		if (start && end) return { from, first: between(from, to, 1 / 3), second: between(to, from, 1 / 3), to };
		const [ahead, back] = [handle(at(-1), from, to), handle(at(2), to, from)];
		return {
			from,
			first: start ? between(from, back, 1 / 2) : ahead,
			second: end ? between(to, ahead, 1 / 2) : back,
			to,
		};
	});
}

/** The curve as a closed polygon of `steps` pieces per span; it begins at point 0. */
export function curveOf(points: OutlinePoints, steps = 12): Place[] {
	return spansOf(points).flatMap((span) => Array.from({ length: steps }, (_, step) => placeOn(span, step / steps)));
}

/** The point of a span at the parameter t, 0 … 1. */
export function placeOn({ from, first, second, to }: Span, t: number): Place {
	const s = 1 - t;
	const [a, b, c, d] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
	return {
		x: a * from.x + b * first.x + c * second.x + d * to.x,
		y: a * from.y + b * first.y + c * second.y + d * to.y,
	};
}

/** The span nearest to a position, and its distance. */
export function nearestSpan(points: OutlinePoints, { x, y }: Place, steps = 12): { span: number; distance: number } {
	const away = curveOf(points, steps).map((place) => Math.hypot(place.x - x, place.y - y));
	const best = away.indexOf(Math.min(...away));
	const before = away[(best + away.length - 1) % away.length];
	const after = away[(best + 1) % away.length];
	// At a control point, the nearer neighbour decides on which side of it the position is.
	const span = best % steps === 0 && before < after ? best / steps - 1 : Math.floor(best / steps);
	return { span: (span + points.length) % points.length, distance: away[best] };
}

/** The control point of a span at `at` towards `to`; `before` is the other neighbour. */
function handle(before: Place, at: Place, to: Place): Place {
	const back = Math.sqrt(Math.hypot(at.x - before.x, at.y - before.y));
	const on = Math.sqrt(Math.hypot(to.x - at.x, to.y - at.y));
	if (back === 0 || on === 0) return between(at, to, 1 / 3);
	const along = (axis: "x" | "y") =>
		(back * back * to[axis] - on * on * before[axis] + (2 * back * back + 3 * back * on + on * on) * at[axis]) /
		(3 * back * (back + on));
	return { x: along("x"), y: along("y") };
}

/**
 * Approximate length of a piece of the core's margin, in leaf lengths, and the range of the number of pieces per span.
 */
const PIECE = 0.015;
const PIECES = { fewest: 2, most: 32 } as const;

/** The curve as the core's polygon, so that page and core agree on outlines that cross themselves. */
function marginOf(points: OutlinePoints): Place[] {
	return spansOf(points).flatMap((span) => {
		const wanted = Math.ceil(Math.hypot(span.to.x - span.from.x, span.to.y - span.from.y) / PIECE);
		const pieces = Math.min(PIECES.most, Math.max(PIECES.fewest, wanted));
		return Array.from({ length: pieces }, (_, piece) => placeOn(span, piece / pieces));
	});
}

/** Twice the least area of a blade, in squared leaf lengths. */
const LEAST_AREA = 0.004;

/** Whether points enclose a blade: counter-clockwise, with some area, without self-intersections. */
export function enclosesBlade(points: OutlinePoints): boolean {
	const curve = marginOf(points);
	return doubleArea(curve) > LEAST_AREA && !crossesItself(curve);
}

/** Whether a closed polygon crosses or touches itself. */
function crossesItself(polygon: readonly Place[]): boolean {
	const { length } = polygon;
	for (let i = 0; i < length; i++) {
		const [a, b] = [polygon[i], polygon[(i + 1) % length]];
		// The last edge is adjacent to the first one.
		for (let j = i + 2; j < (i === 0 ? length - 1 : length); j++) {
			const [c, d] = [polygon[j], polygon[(j + 1) % length]];
			if (apart(a, b, c, d, "x") || apart(a, b, c, d, "y")) continue;
			if (side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0) return true;
		}
	}
	return false;
}

/** Whether two edges do not overlap along an axis; for collinear edges no other test separates them. */
function apart(a: Place, b: Place, c: Place, d: Place, axis: "x" | "y"): boolean {
	return (
		Math.max(a[axis], b[axis]) < Math.min(c[axis], d[axis]) || Math.max(c[axis], d[axis]) < Math.min(a[axis], b[axis])
	);
}

/** Sign of the side of a line on which a point is. */
function side(from: Place, to: Place, { x, y }: Place): number {
	return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
}

function between(from: Place, to: Place, share: number): Place {
	return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
}
