/** Simplifies the mesh of a flat chart: inner vertices are merged cell by cell, vertices of the margin stay. */
import type { Mesh } from "../../../plant/plant";

/** Most rounds that restore the vertices of inverted triangles. */
const ROUNDS = 12;

/**
 * Simplifies a mesh.
 * @param edge distance from the margin of each vertex: 0 on the margin
 * @param cells along a side of the square of texture coordinates
 */
export function lightMesh(mesh: Mesh, edge: Float32Array, cells: number): Mesh {
	const { uvs, indices } = mesh;
	const count = edge.length;
	const cellOf = (vertex: number) =>
		Math.floor(uvs[2 * vertex] * cells) + cells * Math.floor(uvs[2 * vertex + 1] * cells);
	const away = (vertex: number) =>
		Math.hypot(((uvs[2 * vertex] * cells) % 1) - 0.5, ((uvs[2 * vertex + 1] * cells) % 1) - 0.5);
	// The vertex nearest to the middle of each cell replaces all inner vertices of the cell; the margin stays.
	const middles = new Map<number, number>();
	for (let vertex = 0; vertex < count; vertex++) {
		const middle = middles.get(cellOf(vertex));
		if (edge[vertex] > 0 && (middle === undefined || away(vertex) < away(middle))) middles.set(cellOf(vertex), vertex);
	}
	const goes = Uint32Array.from({ length: count }, (_, vertex) =>
		edge[vertex] > 0 ? (middles.get(cellOf(vertex)) as number) : vertex,
	);
	// Vertices of triangles that this has turned over move back.
	for (let round = 0; round < ROUNDS; round++) {
		const turned = new Set<number>();
		for (let at = 0; at < indices.length; at += 3) {
			const corners = indices.subarray(at, at + 3);
			if (doubleArea(uvs, goes[corners[0]], goes[corners[1]], goes[corners[2]]) < 0)
				for (const each of corners) turned.add(each);
		}
		if (turned.size === 0) break;
		for (const vertex of turned) goes[vertex] = vertex;
	}
	return compacted(
		mesh,
		Uint32Array.from(indices, (vertex) => goes[vertex]),
	);
}

/** Returns twice the signed area of the triangle a b c (vertex indices) in texture coordinates: a cross product. */
function doubleArea(uvs: Float32Array, a: number, b: number, c: number): number {
	const [ux, uy] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
	const [vx, vy] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
	return ux * vy - uy * vx;
}

/**
 * Returns a mesh without triangles that have two equal corners, and without unused vertices.
 * @param indices 3 × triangles, which replace the mesh's own
 */
function compacted({ positions, normals, uvs }: Mesh, indices: Uint32Array): Mesh {
	const numbers = new Map<number, number>();
	const remapped: number[] = [];
	for (let at = 0; at < indices.length; at += 3) {
		const corners = [...indices.subarray(at, at + 3)];
		if (new Set(corners).size < 3) continue;
		for (const corner of corners) {
			if (!numbers.has(corner)) numbers.set(corner, numbers.size);
			remapped.push(numbers.get(corner) as number);
		}
	}
	const used = [...numbers.keys()];
	const gathered = (values: Float32Array, width: number) =>
		Float32Array.from(used.flatMap((vertex) => [...values.subarray(width * vertex, width * (vertex + 1))]));
	return {
		positions: gathered(positions, 3),
		normals: gathered(normals, 3),
		uvs: gathered(uvs, 2),
		indices: Uint32Array.from(remapped),
	};
}
