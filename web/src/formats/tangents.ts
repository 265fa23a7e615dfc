/** Tangents along texture coordinates, as in glTF's TANGENT, for pictures of normals. */
import type { Mesh } from "../plant/plant";

/**
 * Computes tangents, 4 × vertices: the unit vector along which u increases, perpendicular to the normal, and the sign
 * by which normal × tangent points up the picture, against v. Means over the adjacent triangles, weighted by their area
 * in the picture and their stretch along u. Until `normalise`, the fourth number is the sum of the triangles' signed
 * areas in the picture.
 */
export function tangentsOf({ positions, normals, uvs, indices }: Mesh): Float32Array {
	const tangents = new Float32Array((positions.length / 3) * 4);
	for (let at = 0; at < indices.length; at += 3) {
		const [a, b, c] = [indices[at], indices[at + 1], indices[at + 2]];
		const [du1, dv1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
		const [du2, dv2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
		// Twice the area in the picture; v runs down, which reverses the orientation.
		const doubleArea = du1 * dv2 - du2 * dv1;
		for (const corner of [a, b, c]) {
			for (let k = 0; k < 3; k++) {
				const edge1 = positions[3 * b + k] - positions[3 * a + k];
				const edge2 = positions[3 * c + k] - positions[3 * a + k];
				tangents[4 * corner + k] += Math.sign(doubleArea) * (edge1 * dv2 - edge2 * dv1);
			}
			tangents[4 * corner + 3] -= doubleArea;
		}
	}
	for (let vertex = 0; vertex < tangents.length / 4; vertex++) {
		const tangent = tangents.subarray(4 * vertex, 4 * vertex + 4);
		normalise(tangent, normals.subarray(3 * vertex, 3 * vertex + 3));
	}
	return tangents;
}

/**
 * Makes a tangent perpendicular to the normal and of unit length (any such vector where the texture determines none),
 * and its fourth number the sign ±1.
 */
function normalise(tangent: Float32Array, [nx, ny, nz]: Float32Array): void {
	const alongNormal = tangent[0] * nx + tangent[1] * ny + tangent[2] * nz;
	let [x, y, z] = [tangent[0] - alongNormal * nx, tangent[1] - alongNormal * ny, tangent[2] - alongNormal * nz];
	if (Math.hypot(x, y, z) < 1e-12) [x, y, z] = Math.abs(nx) < 0.9 ? [0, nz, -ny] : [-nz, 0, nx];
	const length = Math.hypot(x, y, z);
	tangent.set([x / length, y / length, z / length, tangent[3] < 0 ? -1 : 1]);
}
