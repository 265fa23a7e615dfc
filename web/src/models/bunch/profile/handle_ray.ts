/**
 * Converts a pointer's ray in 3-D to a handle's position. Pure maths in the bunch's frame (+Y up, p1 at the origin, p3
 * +X, p4 −X, p5 +Z, p6 −Z), in metres; the result is a point of the handle's 2-D view, in pixels of the profile, so
 * that drag.ts serves both.
 */
import type { Point } from "../../../ui/handles/point";
import { type BunchShape, type Handle, handlePosition, isSide, metresPerPixel, SIDES } from "./handles";

export type BunchVector = readonly [x: number, y: number, z: number];

export interface HandleRay {
	origin: BunchVector;
	/** Any non-zero length. */
	direction: BunchVector;
}

/**
 * Visible freedom of a handle: `plane` is spanned by its axis and the vertical; seen edge-on, only the horizontal
 * `level` or the vertical `plumb` line is left.
 */
export type Freedom = "plane" | "level" | "plumb";

/** Sine of the angle between ray and plane below which the plane counts as seen edge-on (about 10°). */
const GRAZING = 0.17;

/**
 * Sine of the angle between ray and line below which the line counts as seen end-on, so that the pointer's position is
 * undefined on it.
 */
const END_ON = 0.02;

/** Returns the length of a vector. */
const lengthOf = ([x, y, z]: BunchVector): number => Math.hypot(x, y, z);
/** Returns the dot product of two vectors. */
const dot = (a: BunchVector, b: BunchVector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Returns the rightward axis of a handle's view: +X in front, +Z at the side. */
export function across(handle: Handle): BunchVector {
	return isSide(handle) && SIDES[handle].view === "side" ? [0, 0, 1] : [1, 0, 0];
}

/**
 * Returns a handle's position in the bunch's frame, metres.
 * @param unit millimetres per unit of the paper
 */
export function handleVector(shape: BunchShape, handle: Handle, unit: number): BunchVector {
	const { x, y } = handlePosition(shape, handle);
	const pixel = metresPerPixel(unit);
	const [ax, , az] = across(handle);
	return [ax * x * pixel, -y * pixel, az * x * pixel];
}

/**
 * Returns the freedom that is visible along a ray; computed once, when the handle is grabbed, so that it is constant
 * during a drag.
 */
export function visibleFreedom(handle: Handle, { direction }: HandleRay): Freedom {
	if (!isSide(handle)) return "plumb";
	const size = lengthOf(direction);
	const [ax, , az] = across(handle);
	// The plane's normal is horizontal and perpendicular to its axis.
	if (Math.abs(direction[0] * az - direction[2] * ax) > GRAZING * size) return "plane";
	return Math.abs(direction[1]) < Math.abs(dot(direction, [ax, 0, az])) ? "plumb" : "level";
}

/**
 * Returns the point where the ray meets the handle's plane, or comes nearest to its line, in pixels of the handle's flat
 * view; undefined if there is none (seen end-on, or behind the camera).
 * @param unit millimetres per unit of the paper
 */
export function rayToView(
	shape: BunchShape,
	handle: Handle,
	freedom: Freedom,
	ray: HandleRay,
	unit: number,
): Point | undefined {
	const at = handleVector(shape, handle, unit);
	const pixel = metresPerPixel(unit);
	const axis = across(handle);
	const from = handlePosition(shape, handle);
	if (freedom === "level") {
		const right = nearestOnLine(at, axis, ray);
		return right === undefined ? undefined : { x: from.x + right / pixel, y: from.y };
	}
	if (freedom === "plumb") {
		const down = nearestOnLine(at, [0, -1, 0], ray);
		return down === undefined ? undefined : { x: from.x, y: from.y + down / pixel };
	}
	const normal: BunchVector = [axis[2], 0, -axis[0]];
	const distance = -dot(ray.origin, normal) / dot(ray.direction, normal);
	if (!(distance > 0) || !Number.isFinite(distance)) return undefined;
	const hit = ray.origin.map((value, i) => value + distance * ray.direction[i]) as [number, number, number];
	return { x: dot(hit, axis) / pixel, y: -hit[1] / pixel };
}

/**
 * Returns the distance from `point`, along the line in the unit direction `line`, of the line's point that is nearest to
 * the ray; undefined where the line is seen end-on or that point is behind the ray's origin.
 */
function nearestOnLine(point: BunchVector, line: BunchVector, { origin, direction }: HandleRay): number | undefined {
	const size = lengthOf(direction);
	const towards = direction.map((value) => value / size) as [number, number, number];
	const between = origin.map((value, i) => value - point[i]) as [number, number, number];
	const slant = dot(line, towards);
	const sine2 = 1 - slant * slant;
	if (sine2 < END_ON * END_ON) return undefined;
	const alongLine = dot(between, line);
	const alongRay = dot(between, towards);
	if (slant * alongLine < alongRay) return undefined;
	return (alongLine - slant * alongRay) / sine2;
}
