/** Adds an irregular rim that slopes down around a ground. Pure. */
import { noise } from "../../plant/noise";
import type { PartMesh } from "../../plant/part";
import type { Ground } from "./finer_ground";
import type { GroundGrid } from "./ground_grid";

/**
 * Width of the rim as a share of the ground's shorter side, its maximum in metres, its variation as a share, and its
 * depth relative to the width.
 */
const REACH = 0.075;
const FARTHEST = 3;
const UNEVEN = 0.75;
const FALL = 0.55;
/** Rows of vertices in the rim, and additional directions at a corner. */
const RINGS = 4;
const TURNS = 4;

/** A vertex at the edge of the ground, and a direction outwards. */
interface EdgeVertex {
	readonly vertex: number;
	readonly out: readonly [x: number, z: number];
}

/**
 * Adds a rim; its vertices come after all others. `rim` is the distance of each vertex into the rim: 0 on the ground,
 * 1 at the outer end.
 * @param short length of the ground's shorter side, metres
 */
export function withRim({ mesh, grid }: Ground, short: number): { mesh: PartMesh; rim: Float32Array } {
	const edge = groundEdge(grid);
	const reach = Math.min(FARTHEST, REACH * short);
	const { positions, normals, sky, uvs } = mesh;
	const places = [...positions];
	const ways = [...normals];
	const open = [...(sky ?? new Uint8Array(positions.length / 3).fill(255))];
	const flat = [...uvs];
	const rim = open.map(() => 0);
	for (let ring = 1; ring <= RINGS; ring++) {
		const share = ring / RINGS;
		for (const { vertex, out } of edge) {
			const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
			// The noise depends on the final position, so that neighbours and both ends of the loop agree.
			const at = [(x + reach * out[0]) / reach, (z + reach * out[1]) / reach] as const;
			const far =
				reach * share * (1 - UNEVEN * (0.65 * noise(at[0] / 2.5, at[1] / 2.5, 7) + 0.35 * noise(at[0], at[1], 3)));
			const slope = (2 * FALL * share) / Math.hypot(1, 2 * FALL * share);
			places.push(x + far * out[0], y - FALL * far * share, z + far * out[1]);
			ways.push(slope * out[0], Math.sqrt(1 - slope * slope), slope * out[1]);
			open.push(open[vertex]);
			flat.push(x + far * out[0], z + far * out[1]);
			rim.push(share);
		}
	}
	const made = {
		...mesh,
		positions: Float32Array.from(places),
		normals: Float32Array.from(ways),
		uvs: Float32Array.from(flat),
		indices: Uint32Array.from([...mesh.indices, ...rimTriangles(edge, positions.length / 3)]),
		sky: Uint8Array.from(open),
	};
	return { mesh: made, rim: Float32Array.from(rim) };
}

/**
 * Triangles between the ground and the rim's rows.
 * @param first index of the rim's first vertex
 */
function rimTriangles(edge: readonly EdgeVertex[], first: number): number[] {
	const indices: number[] = [];
	const at = (ring: number, column: number) => {
		const round = column % edge.length;
		return ring === 0 ? edge[round].vertex : first + edge.length * (ring - 1) + round;
	};
	for (let ring = 0; ring < RINGS; ring++)
		for (let column = 0; column < edge.length; column++) {
			const [a, b, c, d] = [at(ring, column), at(ring, column + 1), at(ring + 1, column + 1), at(ring + 1, column)];
			// At a corner the ground has one vertex and several directions.
			if (a !== b) indices.push(a, b, c);
			indices.push(a, c, d);
		}
	return indices;
}

/** Edge vertices around the ground, with the outside on the left; a corner has several directions. */
function groundEdge({ across, deep }: GroundGrid): EdgeVertex[] {
	const row = across + 1;
	const sides = [
		{ from: 0, step: 1, count: across, out: [0, -1], next: [1, 0] },
		{ from: across, step: row, count: deep, out: [1, 0], next: [0, 1] },
		{ from: row * deep + across, step: -1, count: across, out: [0, 1], next: [-1, 0] },
		{ from: row * deep, step: -row, count: deep, out: [-1, 0], next: [0, -1] },
	] as const;
	const edge: EdgeVertex[] = [];
	for (const { from, step, count, out, next } of sides) {
		for (let i = 1; i <= count; i++) edge.push({ vertex: from + step * i, out });
		for (let turn = 1; turn <= TURNS; turn++) {
			const angle = (0.5 * Math.PI * turn) / TURNS;
			const [c, s] = [Math.cos(angle), Math.sin(angle)];
			edge.push({ vertex: from + step * count, out: [c * out[0] + s * next[0], c * out[1] + s * next[1]] });
		}
	}
	return edge;
}
