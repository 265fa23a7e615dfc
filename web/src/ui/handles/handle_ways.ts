/** Dragging of handles in three dimensions along rays. Pure functions, in the plant's metres. */
import type { HandleVector } from "./plant_handle";

/** A ray; the direction has any length but 0. */
export interface PointerRay {
	readonly origin: HandleVector;
	readonly direction: HandleVector;
}

/** Sine of the angle between ray and plane below which the plane counts as seen edge-on (about 10°). */
const GRAZING = 0.17;
/**
 * Sine of the angle between ray and line below which the line counts as seen end-on, where a pointer's position is
 * meaningless.
 */
const END_ON = 0.02;

/**
 * Returns the directions in which a handle can visibly move. Computed once at the beginning of a drag, so that they
 * stay constant.
 */
export function visibleWays(along: readonly HandleVector[], ray: PointerRay): readonly HandleVector[] {
	if (along.length < 2) return along;
	const sight = unit(ray.direction);
	if (along.length > 2) {
		// Of three perpendicular directions, the two most visible ones.
		const deepest = Math.max(...along.map((way) => Math.abs(dot(way, sight))));
		const hidden = along.findIndex((way) => Math.abs(dot(way, sight)) === deepest);
		return along.filter((_, i) => i !== hidden);
	}
	if (Math.abs(dot(cross(along[0], along[1]), sight)) > GRAZING) return along;
	const [firstDepth, secondDepth] = along.map((way) => Math.abs(dot(way, sight)));
	return [firstDepth <= secondDepth ? along[0] : along[1]];
}

/** Returns the position along the directions that is under the ray, or nearest to it; undefined if there is none. */
export function placeUnder(at: HandleVector, ways: readonly HandleVector[], ray: PointerRay): HandleVector | undefined {
	return ways.length === 2 ? pointOnPlane(at, cross(ways[0], ways[1]), ray) : pointOnLine(at, ways[0], ray);
}

/**
 * Returns the point where a ray meets a plane; undefined if it is behind the eye or the ray is parallel.
 * @param at a point of the plane
 */
function pointOnPlane(
	at: HandleVector,
	normal: HandleVector,
	{ origin, direction }: PointerRay,
): HandleVector | undefined {
	const distance = dot(minus(at, origin), normal) / dot(direction, normal);
	return distance > 0 && Number.isFinite(distance) ? plus(origin, direction, distance) : undefined;
}

/**
 * Returns the point on a line nearest to a ray; undefined if the ray nearly follows the line, or if the point is behind
 * the eye.
 * @param at a point of the line
 * @param line direction of the line, of unit length
 */
function pointOnLine(
	at: HandleVector,
	line: HandleVector,
	{ origin, direction }: PointerRay,
): HandleVector | undefined {
	const sight = unit(direction);
	const fromPoint = minus(origin, at);
	const slant = dot(line, sight);
	const sine2 = 1 - slant * slant;
	if (sine2 < END_ON * END_ON) return undefined;
	const [alongLine, alongSight] = [dot(fromPoint, line), dot(fromPoint, sight)];
	// The nearest position is behind the eye.
	if (slant * alongLine < alongSight) return undefined;
	return plus(at, line, (alongLine - slant * alongSight) / sine2);
}

/** Returns the dot product of two vectors. */
const dot = (a: HandleVector, b: HandleVector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** Returns the difference a − b of two vectors. */
const minus = (a: HandleVector, b: HandleVector): HandleVector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** Returns a + by · b. */
export const plus = (a: HandleVector, b: HandleVector, by: number): HandleVector => [
	a[0] + by * b[0],
	a[1] + by * b[1],
	a[2] + by * b[2],
];
/** Returns the cross product of two vectors. */
const cross = (a: HandleVector, b: HandleVector): HandleVector => [
	a[1] * b[2] - a[2] * b[1],
	a[2] * b[0] - a[0] * b[2],
	a[0] * b[1] - a[1] * b[0],
];

/** Returns the unit vector of a direction. */
function unit(a: HandleVector): HandleVector {
	const length = Math.hypot(...a);
	return [a[0] / length, a[1] / length, a[2] / length];
}
