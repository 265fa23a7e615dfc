/** How a ground ends: as a piece of earth does, in an uneven rim that falls away. Pure. */
import { noise } from "../../plant/noise";
import type { PartMesh } from "../../plant/part";
import type { Ground } from "./finer_ground";
import type { GroundGrid } from "./ground_grid";

/** How far the rim reaches, as a share of the ground's shorter side, and metres at the most; how unevenly, and how deep it falls, of that. */
const REACH = 0.075;
const FARTHEST = 3;
const UNEVEN = 0.75;
const FALL = 0.55;
/** Rows of vertices in it, and how many more ways out there are at a corner. */
const RINGS = 4;
const TURNS = 4;

/** Where the ground ends: a place of the grid, and which way is out. */
interface Brink {
	readonly vertex: number;
	readonly out: readonly [x: number, z: number];
}

/**
 * A ground with a rim about it, whose vertices are behind all others; and how far out in the rim each vertex is: 0 on the ground, 1 where
 * all ends.
 * @param short the ground's shorter side, metres
 */
export function rimmed({ mesh, grid }: Ground, short: number): { mesh: PartMesh; rim: Float32Array } {
	const brinks = brinksOf(grid);
	const reach = Math.min(FARTHEST, REACH * short);
	const { positions, normals, sky, uvs } = mesh;
	const places = [...positions];
	const ways = [...normals];
	const open = [...(sky ?? new Uint8Array(positions.length / 3).fill(255))];
	const flat = [...uvs];
	const rim = open.map(() => 0);
	for (let ring = 1; ring <= RINGS; ring++) {
		const share = ring / RINGS;
		for (const { vertex, out } of brinks) {
			const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
			// By where it comes to lie, so that neighbours and both ends of the round agree.
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
		indices: Uint32Array.from([...mesh.indices, ...joined(brinks, positions.length / 3)]),
		sky: Uint8Array.from(open),
	};
	return { mesh: made, rim: Float32Array.from(rim) };
}

/**
 * The triangles between the ground, the rim's first row, and each row and the next.
 * @param first the first vertex of the rim
 */
function joined(brinks: readonly Brink[], first: number): number[] {
	const indices: number[] = [];
	const at = (ring: number, brink: number) => {
		const round = brink % brinks.length;
		return ring === 0 ? brinks[round].vertex : first + brinks.length * (ring - 1) + round;
	};
	for (let ring = 0; ring < RINGS; ring++)
		for (let brink = 0; brink < brinks.length; brink++) {
			const [a, b, c, d] = [at(ring, brink), at(ring, brink + 1), at(ring + 1, brink + 1), at(ring + 1, brink)];
			// At a corner there is one place and many ways out.
			if (a !== b) indices.push(a, b, c);
			indices.push(a, c, d);
		}
	return indices;
}

/** Once round the ground, so that what lies out is at the left hand of who goes: each corner with several ways out. */
function brinksOf({ across, deep }: GroundGrid): Brink[] {
	const row = across + 1;
	const sides = [
		{ from: 0, step: 1, count: across, out: [0, -1], next: [1, 0] },
		{ from: across, step: row, count: deep, out: [1, 0], next: [0, 1] },
		{ from: row * deep + across, step: -1, count: across, out: [0, 1], next: [-1, 0] },
		{ from: row * deep, step: -row, count: deep, out: [-1, 0], next: [0, -1] },
	] as const;
	const brinks: Brink[] = [];
	for (const { from, step, count, out, next } of sides) {
		for (let i = 1; i <= count; i++) brinks.push({ vertex: from + step * i, out });
		for (let turn = 1; turn <= TURNS; turn++) {
			const angle = (0.5 * Math.PI * turn) / TURNS;
			const [c, s] = [Math.cos(angle), Math.sin(angle)];
			brinks.push({ vertex: from + step * count, out: [c * out[0] + s * next[0], c * out[1] + s * next[1]] });
		}
	}
	return brinks;
}
