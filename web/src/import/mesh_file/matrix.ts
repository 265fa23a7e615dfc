/** Affine matrices as in glTF: 4 × 4, column-major. */

export type Mat4 = readonly number[];

interface Placing {
	translation?: readonly number[];
	/** A quaternion x, y, z, w. */
	rotation?: readonly number[];
	scale?: readonly number[];
}

const identity: Mat4 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Returns the matrix that scales, then rotates, then translates. */
function of({ translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }: Placing): Mat4 {
	const [x, y, z, w] = rotation;
	const [sx, sy, sz] = scale;
	return [
		...[sx * (1 - 2 * (y * y + z * z)), sx * 2 * (x * y + w * z), sx * 2 * (x * z - w * y), 0],
		...[sy * 2 * (x * y - w * z), sy * (1 - 2 * (x * x + z * z)), sy * 2 * (y * z + w * x), 0],
		...[sz * 2 * (x * z + w * y), sz * 2 * (y * z - w * x), sz * (1 - 2 * (x * x + y * y)), 0],
		...[...translation, 1],
	];
}

/** Returns the product a · b: the transform b, followed by a. */
function times(a: Mat4, b: Mat4): Mat4 {
	return Array.from({ length: 16 }, (_, i) => {
		const [row, column] = [i % 4, 4 * Math.floor(i / 4)];
		return a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] + a[row + 12] * b[column + 3];
	});
}

/** Returns the transformed point. */
function point(m: Mat4, x: number, y: number, z: number): [number, number, number] {
	const coordinate = (row: number) => m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12];
	return [coordinate(0), coordinate(1), coordinate(2)];
}

/** Returns whether a transform mirrors: whether the determinant of its upper left 3 × 3 matrix is negative. */
function mirrors([a, b, c, , d, e, f, , g, h, i]: Mat4): boolean {
	return a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e) < 0;
}

export const Matrix = { identity, of, times, point, mirrors };
