/**
 * Positions and normals in fewer bytes (KHR_mesh_quantization): 16 bits per coordinate, 8 bits per component of a
 * normal.
 */
import { shortFloat } from "./numbers";

const SHORT_MAX = 32767;
const BYTE_MAX = 127;
/** Components of a vertex, padded so that each begins at a multiple of four bytes. */
const PADDED = 4;

/** Returns positions (3 × vertices) relative to `centre`. */
export function relative(positions: Float32Array, centre: readonly number[]): Float32Array {
	const [x, y, z] = centre;
	const result = new Float32Array(positions.length);
	for (let i = 0; i < positions.length; i += 3) {
		result[i] = positions[i] - x;
		result[i + 1] = positions[i + 1] - y;
		result[i + 2] = positions[i + 2] - z;
	}
	return result;
}

/** Returns the middle of the positions' bounding box. */
export function wholeBounds(positions: Float32Array): [number, number, number] {
	const low = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
	const high = low.map((value) => -value);
	for (let i = 0; i < positions.length; i++) {
		const axis = i % 3;
		if (positions[i] < low[axis]) low[axis] = positions[i];
		if (positions[i] > high[axis]) high[axis] = positions[i];
	}
	return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
}

/**
 * Quantises positions to 4 × vertices (the fourth is padding): each coordinate relative to `centre`, in steps of
 * `scale` / 32767. One scale for all three, so that normals stay right.
 */
export function quantised(positions: Float32Array, centre: readonly number[]): { values: Int16Array; scale: number } {
	let greatest = 0;
	for (let i = 0; i < positions.length; i++) greatest = Math.max(greatest, Math.abs(positions[i] - centre[i % 3]));
	// Rounded up to a float32, so that all coordinates fit.
	const scale = greatest > 0 ? shortFloat(Math.fround(greatest * (1 + 1e-7))) : 1;
	const steps = SHORT_MAX / scale;
	const values = new Int16Array((positions.length / 3) * PADDED);
	for (let i = 0, at = 0; i < positions.length; i += 3, at += PADDED) {
		for (let axis = 0; axis < 3; axis++) {
			const value = Math.round((positions[i + axis] - centre[axis]) * steps);
			values[at + axis] = Math.max(-SHORT_MAX, Math.min(SHORT_MAX, value));
		}
	}
	return { values, scale };
}

/** Returns tangents in steps of 1 / 127: 4 × vertices, without padding. */
export function quantisedTangents(tangents: Float32Array): Int8Array {
	return Int8Array.from(tangents, (value) => Math.round(BYTE_MAX * value));
}

/** Returns normals in steps of 1 / 127: 4 × vertices, the fourth number is padding. */
export function quantisedNormals(normals: Float32Array): Int8Array {
	const values = new Int8Array((normals.length / 3) * PADDED);
	for (let i = 0, at = 0; i < normals.length; i += 3, at += PADDED) {
		for (let axis = 0; axis < 3; axis++) values[at + axis] = Math.round(BYTE_MAX * normals[i + axis]);
	}
	return values;
}
