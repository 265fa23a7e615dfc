/** Width of a mesh around each vertex and the direction in which crowd_material.ts widens it. Pure. */
import { type PackedMesh, PLACE_STEPS } from "../../../plant/packed_mesh";

/**
 * Numbers per vertex: a unit vector scaled to `STEPS`, and the square root of the width as a share of the mesh's unit,
 * scaled likewise.
 */
export const EDGE_NORMAL_SIZE = 4;
const STEPS = 127;

type Mesh = Pick<PackedMesh, "positions" | "indices">;

/**
 * Cache by mesh: 300,000 triangles take 90 ms, and plants are uploaded again when they come near or the graphics
 * context is lost.
 */
const cache = new WeakMap<Mesh, Int8Array<ArrayBuffer>>();

/** Returns the edge normals of a mesh, computed at the first use: meshes are immutable. */
export function edgeNormalsOf(mesh: Mesh): Int8Array<ArrayBuffer> {
	const edgeNormals = cache.get(mesh) ?? computeEdgeNormals(mesh);
	cache.set(mesh, edgeNormals);
	return edgeNormals;
}

/**
 * Computes the edge normals, EDGE_NORMAL_SIZE numbers per vertex. The vector points out of a tube or across the margin
 * of a sheet: from the centre of each triangle, without the component along the triangle (`directionAlong`). The width
 * is that of the widest adjacent triangle.
 */
function computeEdgeNormals({ positions, indices }: Mesh): Int8Array<ArrayBuffer> {
	const vertices = positions.length / 3;
	const vectors = new Float32Array(3 * vertices);
	const widths = new Float32Array(vertices);
	const [direction, width] = [new Float32Array(3), new Float32Array(1)];
	for (let i = 0; i < indices.length; i += 3) {
		const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
		directionAlong(positions, a, b, c, direction, width);
		for (const at of [a, b, c]) {
			// From the triangle's centre to this corner, without the component along the triangle.
			const x = positions[at] - (positions[a] + positions[b] + positions[c]) / 3;
			const y = positions[at + 1] - (positions[a + 1] + positions[b + 1] + positions[c + 1]) / 3;
			const z = positions[at + 2] - (positions[a + 2] + positions[b + 2] + positions[c + 2]) / 3;
			const component = x * direction[0] + y * direction[1] + z * direction[2];
			vectors[at] += x - component * direction[0];
			vectors[at + 1] += y - component * direction[1];
			vectors[at + 2] += z - component * direction[2];
			if (width[0] > widths[at / 3]) widths[at / 3] = width[0];
		}
	}
	const edgeNormals = new Int8Array(EDGE_NORMAL_SIZE * vertices);
	for (let v = 0; v < vertices; v++) {
		const length = Math.hypot(vectors[3 * v], vectors[3 * v + 1], vectors[3 * v + 2]) || 1;
		for (let k = 0; k < 3; k++)
			edgeNormals[EDGE_NORMAL_SIZE * v + k] = Math.round((STEPS * vectors[3 * v + k]) / length);
		edgeNormals[EDGE_NORMAL_SIZE * v + 3] = Math.min(STEPS, Math.ceil(STEPS * Math.sqrt(widths[v] / PLACE_STEPS)));
	}
	return edgeNormals;
}

/**
 * Computes the unit vector along a triangle, and its width across the longest edge. The vector follows the edge of
 * medium length: the longest edge of a tube's triangle is oblique.
 * @param a index of the first corner's x in `positions`; `b` and `c` likewise
 * @param direction receives the vector
 * @param width receives the width, in its first element
 */
function directionAlong(
	positions: Int16Array,
	a: number,
	b: number,
	c: number,
	direction: Float32Array,
	width: Float32Array,
): void {
	const [ux, uy, uz] = [
		positions[b] - positions[a],
		positions[b + 1] - positions[a + 1],
		positions[b + 2] - positions[a + 2],
	];
	const [vx, vy, vz] = [
		positions[c] - positions[a],
		positions[c + 1] - positions[a + 1],
		positions[c + 2] - positions[a + 2],
	];
	const [wx, wy, wz] = [vx - ux, vy - uy, vz - uz];
	const [u, v, w] = [ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz, wx * wx + wy * wy + wz * wz];
	const longest = Math.max(u, v, w);
	const middle = u + v + w - longest - Math.min(u, v, w);
	const [x, y, z] = middle === u ? [ux, uy, uz] : middle === v ? [vx, vy, vz] : [wx, wy, wz];
	const length = Math.sqrt(middle) || 1;
	direction[0] = x / length;
	direction[1] = y / length;
	direction[2] = z / length;
	const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
	width[0] = longest > 0 ? Math.sqrt((nx * nx + ny * ny + nz * nz) / longest) : 0;
}
