/** Rotations from +Y to a direction. */

/** A unit quaternion. */
export interface Quaternion {
	x: number;
	y: number;
	z: number;
	w: number;
}

/**
 * Returns the rotation from +Y to the unit vector (x, y, z): half a turn about X, then the shortest way from −Y. Most
 * fruits hang, so the one direction with an undetermined roll is at +Y, where few point; there it is the identity.
 */
export function fromUp(x: number, y: number, z: number): Quaternion {
	const across = x * x + z * z;
	// 1 − y, without losing digits to the subtraction near +Y.
	const lift = y > 0 ? across / (1 + y) : 1 - y;
	const length = Math.sqrt(lift * lift + across);
	if (length === 0) return { x: 0, y: 0, z: 0, w: 1 };
	return { x: lift / length, y: x / length, z: 0, w: z / length };
}

/** A 3 × 3 matrix, row by row. */
export type Matrix3 = [number, number, number, number, number, number, number, number, number];

/** Returns the rotation as a matrix. */
export function rotationMatrix({ x, y, z, w }: Quaternion): Matrix3 {
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

/** Rotates, scales and moves `vectors`, and writes them into `into` from `at` on. */
export function placeVectors(
	vectors: Float32Array,
	turn: Matrix3,
	scale: number,
	centre: readonly number[],
	into: Float32Array | Float64Array,
	at = 0,
): void {
	const [a, b, c, d, e, f, g, h, k] = turn;
	const [cx, cy, cz] = centre;
	for (let i = 0; i < vectors.length; i += 3) {
		const x = vectors[i];
		const y = vectors[i + 1];
		const z = vectors[i + 2];
		into[at + i] = cx + scale * (a * x + b * y + c * z);
		into[at + i + 1] = cy + scale * (d * x + e * y + f * z);
		into[at + i + 2] = cz + scale * (g * x + h * y + k * z);
	}
}
