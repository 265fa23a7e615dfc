/** How the shared berry, tip scar towards +Y, is turned to stand on its pedicel. */
import { rounded } from "./numbers";

/** A unit quaternion. */
export interface Quaternion {
	x: number;
	y: number;
	z: number;
	w: number;
}

/**
 * The rotation that takes +Y to the unit vector (x, y, z): half a turn about X, then the shortest way from −Y. Berries
 * mostly hang, so the one direction where the roll is undetermined is put at +Y, where few berries point; there it is
 * the identity.
 */
export function fromUp(x: number, y: number, z: number): Quaternion {
	const across = x * x + z * z;
	// 1 − y, without losing digits to the subtraction near +Y.
	const lift = y > 0 ? across / (1 + y) : 1 - y;
	const length = Math.sqrt(lift * lift + across);
	if (length === 0) return { x: 0, y: 0, z: 0, w: 1 };
	return { x: lift / length, y: x / length, z: 0, w: z / length };
}

/** The rotation that takes +Y to the direction of berry `index`; `directions` as in `Berries`. */
export function turnOf(directions: Float32Array, index: number): Quaternion {
	return fromUp(directions[3 * index], directions[3 * index + 1], directions[3 * index + 2]);
}

/** Well inside what validators allow a quaternion to be off its unit length. */
const DECIMALS = 7;

/** As a glTF node has it. */
export function writtenTurn({ x, y, z, w }: Quaternion): number[] {
	return [x, y, z, w].map((value) => rounded(value, DECIMALS));
}

/** A 3 × 3 matrix, row by row. */
export type Rows = [number, number, number, number, number, number, number, number, number];

/** The same rotation as a matrix. */
export function rows({ x, y, z, w }: Quaternion): Rows {
	return [
		1 - 2 * (y * y + z * z),
		2 * (x * y - w * z),
		2 * (x * z + w * y),
		2 * (x * y + w * z),
		1 - 2 * (x * x + z * z),
		2 * (y * z - w * x),
		2 * (x * z - w * y),
		2 * (y * z + w * x),
		1 - 2 * (x * x + y * y),
	];
}
