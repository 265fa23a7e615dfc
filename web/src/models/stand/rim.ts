/** Adds an irregular rim that slopes down around a ground. Pure. */
import { noise } from "../../plant/noise";
import type { PartMesh } from "../../plant/part";
import type { Ground } from "./finer_ground";
import type { GroundGrid } from "./ground_grid";

/** Width of the rim as a share of the ground's shorter side, and its maximum in metres. */
const WIDTH_SHARE = 0.075;
const MAX_WIDTH = 3;
/** Share of the width by which it varies. */
const UNEVEN = 0.75;
/** Depth of the rim's outer end relative to the width. */
const FALL = 0.55;
/** Rows of vertices in the rim. */
const RINGS = 4;
/** Number of additional directions at a corner. */
const CORNER_DIRECTIONS = 4;

/** A vertex at the edge of the ground, and a direction outwards. */
interface EdgeVertex {
	readonly vertex: number;
	readonly out: readonly [x: number, z: number];
}

/**
 * Adds a rim, so that the ground does not end in a straight edge in the air; its vertices come after all others. `rim`
 * is the distance of each vertex into the rim: 0 on the ground, 1 at the outer end.
 * @param shorterSide length of the ground's shorter side, metres
 */
export function withRim({ mesh, grid }: Ground, shorterSide: number): { mesh: PartMesh; rim: Float32Array } {
	const edge = groundEdge(grid);
	const width = Math.min(MAX_WIDTH, WIDTH_SHARE * shorterSide);
	const { positions, normals, sky, uvs } = mesh;
	const allPositions = [...positions];
	const allNormals = [...normals];
	const allSky = [...(sky ?? new Uint8Array(positions.length / 3).fill(255))];
	const allUvs = [...uvs];
	const rim = allSky.map(() => 0);
	for (let ring = 1; ring <= RINGS; ring++) {
		const share = ring / RINGS;
		for (const { vertex, out } of edge) {
			const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
			// The noise depends on the final position, so that neighbours and both ends of the loop agree.
			const noiseAt = [(x + width * out[0]) / width, (z + width * out[1]) / width] as const;
			const distance =
				width *
				share *
				(1 - UNEVEN * (0.65 * noise(noiseAt[0] / 2.5, noiseAt[1] / 2.5, 7) + 0.35 * noise(noiseAt[0], noiseAt[1], 3)));
			// The rim falls as a parabola; its normal leans outwards.
			const slope = (2 * FALL * share) / Math.hypot(1, 2 * FALL * share);
			allPositions.push(x + distance * out[0], y - FALL * distance * share, z + distance * out[1]);
			allNormals.push(slope * out[0], Math.sqrt(1 - slope * slope), slope * out[1]);
			allSky.push(allSky[vertex]);
			allUvs.push(x + distance * out[0], z + distance * out[1]);
			rim.push(share);
		}
	}
	const rimmed = {
		...mesh,
		positions: Float32Array.from(allPositions),
		normals: Float32Array.from(allNormals),
		uvs: Float32Array.from(allUvs),
		indices: Uint32Array.from([...mesh.indices, ...rimTriangles(edge, positions.length / 3)]),
		sky: Uint8Array.from(allSky),
	};
	return { mesh: rimmed, rim: Float32Array.from(rim) };
}

/**
 * Returns the triangles between the ground and the rim's rows.
 * @param edge vertices along the edge of the ground
 * @param first index of the rim's first vertex
 */
function rimTriangles(edge: readonly EdgeVertex[], first: number): number[] {
	const indices: number[] = [];
	const vertexAt = (ring: number, column: number) => {
		const round = column % edge.length;
		return ring === 0 ? edge[round].vertex : first + edge.length * (ring - 1) + round;
	};
	for (let ring = 0; ring < RINGS; ring++)
		for (let column = 0; column < edge.length; column++) {
			const [a, b, c, d] = [
				vertexAt(ring, column),
				vertexAt(ring, column + 1),
				vertexAt(ring + 1, column + 1),
				vertexAt(ring + 1, column),
			];
			// At a corner the ground has one vertex and several directions.
			if (a !== b) indices.push(a, b, c);
			indices.push(a, c, d);
		}
	return indices;
}

/** Lists the edge vertices around the ground, with the outside on the left; a corner has several directions. */
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
		for (let turn = 1; turn <= CORNER_DIRECTIONS; turn++) {
			const angle = (0.5 * Math.PI * turn) / CORNER_DIRECTIONS;
			const [c, s] = [Math.cos(angle), Math.sin(angle)];
			edge.push({ vertex: from + step * count, out: [c * out[0] + s * next[0], c * out[1] + s * next[1]] });
		}
	}
	return edge;
}
