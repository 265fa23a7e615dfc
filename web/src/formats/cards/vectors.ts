/** Operations on vectors of three numbers. */
import type { Vector } from "../../plant/part";

export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const lengthOf = (a: Vector): number => Math.hypot(a[0], a[1], a[2]);
export const cross = (a: Vector, b: Vector): Vector => [
	a[1] * b[2] - a[2] * b[1],
	a[2] * b[0] - a[0] * b[2],
	a[0] * b[1] - a[1] * b[0],
];

/** Returns the vector at unit length; `otherwise` where it has no length. */
export function unit(a: Vector, otherwise: Vector = [0, 1, 0]): Vector {
	const length = lengthOf(a);
	return length > 1e-12 ? scaled(a, 1 / length) : otherwise;
}

/** Returns a unit vector perpendicular to a unit vector. */
export function perpendicular(a: Vector): Vector {
	return unit(cross(a, Math.abs(a[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
}

/** Interpolates linearly from one point to another. */
export const between = (a: Vector, b: Vector, share: number): Vector => add(a, scaled(subtract(b, a), share));
