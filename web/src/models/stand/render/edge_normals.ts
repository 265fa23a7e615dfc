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
const known = new WeakMap<Mesh, Int8Array<ArrayBuffer>>();

/** Edge normals of a mesh, computed once: meshes are immutable. */
export function edgeNormalsOf(mesh: Mesh): Int8Array<ArrayBuffer> {
	const edgeNormals = known.get(mesh) ?? found(mesh);
	known.set(mesh, edgeNormals);
	return edgeNormals;
}

/**
 * Computes 4 × vertices. The vector points out of a tube or across the margin of a sheet: from the centre of each
 * triangle, without the component along the triangle (`alongOf`). The width is that of the widest adjacent triangle.
 */
function found({ positions, indices }: Mesh): Int8Array<ArrayBuffer> {
	const vertices = positions.length / 3;
	const ways = new Float32Array(3 * vertices);
	const widths = new Float32Array(vertices);
	const [way, width] = [new Float32Array(3), new Float32Array(1)];
	for (let i = 0; i < indices.length; i += 3) {
		const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
		alongOf(positions, a, b, c, way, width);
		for (const at of [a, b, c]) {
			const x = positions[at] - (positions[a] + positions[b] + positions[c]) / 3;
			const y = positions[at + 1] - (positions[a + 1] + positions[b + 1] + positions[c + 1]) / 3;
			const z = positions[at + 2] - (positions[a + 2] + positions[b + 2] + positions[c + 2]) / 3;
			const along = x * way[0] + y * way[1] + z * way[2];
			ways[at] += x - along * way[0];
			ways[at + 1] += y - along * way[1];
			ways[at + 2] += z - along * way[2];
			if (width[0] > widths[at / 3]) widths[at / 3] = width[0];
		}
	}
	const edgeNormals = new Int8Array(EDGE_NORMAL_SIZE * vertices);
	for (let v = 0; v < vertices; v++) {
		const length = Math.hypot(ways[3 * v], ways[3 * v + 1], ways[3 * v + 2]) || 1;
		for (let k = 0; k < 3; k++) edgeNormals[EDGE_NORMAL_SIZE * v + k] = Math.round((STEPS * ways[3 * v + k]) / length);
		edgeNormals[EDGE_NORMAL_SIZE * v + 3] = Math.min(STEPS, Math.ceil(STEPS * Math.sqrt(widths[v] / PLACE_STEPS)));
	}
	return edgeNormals;
}

/**
 * Unit vector along a triangle, and its width across the longest edge. The vector follows the edge of medium length:
 * the longest edge of a tube's triangle is oblique.
 */
function alongOf(at: Int16Array, a: number, b: number, c: number, way: Float32Array, width: Float32Array): void {
	const [ux, uy, uz] = [at[b] - at[a], at[b + 1] - at[a + 1], at[b + 2] - at[a + 2]];
	const [vx, vy, vz] = [at[c] - at[a], at[c + 1] - at[a + 1], at[c + 2] - at[a + 2]];
	const [wx, wy, wz] = [vx - ux, vy - uy, vz - uz];
	const [u, v, w] = [ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz, wx * wx + wy * wy + wz * wz];
	const longest = Math.max(u, v, w);
	const middle = u + v + w - longest - Math.min(u, v, w);
	const [x, y, z] = middle === u ? [ux, uy, uz] : middle === v ? [vx, vy, vz] : [wx, wy, wz];
	const length = Math.sqrt(middle) || 1;
	way[0] = x / length;
	way[1] = y / length;
	way[2] = z / length;
	const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
	width[0] = longest > 0 ? Math.sqrt((nx * nx + ny * ny + nz * nz) / longest) : 0;
}
