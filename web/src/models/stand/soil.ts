/** The ground as it is drawn and written: mottled, and ending as a piece of earth does, in an uneven rim that falls away. Pure. */
import { hashFraction, noise } from "../../plant/noise";
import type { PartMesh } from "../../plant/part";

/** Cells along a side, at the least: mottles have to show on a bed, too. */
const FEWEST = 28;
/** How far the rim reaches, as a share of the ground's shorter side, and metres at the most; how unevenly, and how deep it falls, of that. */
const REACH = 0.075;
const FARTHEST = 3;
const UNEVEN = 0.75;
const FALL = 0.55;
/** Rows of vertices in it, and how many more ways out there are at a corner. */
const RINGS = 4;
const TURNS = 4;
/** Mottles to the shorter side, and how much lighter and darker they are. */
const MOTTLES = 9;
const CONTRAST = 0.6;

export interface Soil {
	readonly mesh: PartMesh;
	/** How light each vertex is, times the ground's colour. */
	readonly light: Float32Array;
	/** How far out in the rim each vertex is: 0 on the ground, 1 where all ends. */
	readonly rim: Float32Array;
}

/** A grid that is evenly spaced, row by row from the back. */
interface Grid {
	readonly mesh: PartMesh;
	readonly across: number;
	readonly deep: number;
}

/** Where the ground ends: a place of the grid, and which way is out. */
interface Brink {
	readonly vertex: number;
	readonly out: readonly [x: number, z: number];
}

/** @param mesh as the core lays it */
export function soilOf(mesh: PartMesh): Soil {
	const grid = finer(gridOf(mesh));
	const { width, depth } = sizeOf(grid.mesh);
	const short = Math.min(width, depth);
	const brinks = brinksOf(grid);
	const reach = Math.min(FARTHEST, REACH * short);
	const { positions, normals, sky, uvs } = grid.mesh;
	const places = [...positions];
	const ways = [...normals];
	const open = [...(sky ?? new Uint8Array(positions.length / 3).fill(255))];
	const flat = [...uvs];
	const indices = [...grid.mesh.indices];
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
		}
	}
	const first = positions.length / 3;
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
	const made = {
		...mesh,
		positions: Float32Array.from(places),
		normals: Float32Array.from(ways),
		uvs: Float32Array.from(flat),
		indices: Uint32Array.from(indices),
		sky: Uint8Array.from(open),
	};
	const rim = Float32Array.from({ length: places.length / 3 }, (_, v) =>
		v < first ? 0 : (1 + Math.floor((v - first) / brinks.length)) / RINGS,
	);
	return { mesh: made, light: mottled(places, short), rim };
}

function sizeOf({ positions }: PartMesh) {
	return { width: -2 * positions[0], depth: -2 * positions[2] };
}

function gridOf(mesh: PartMesh): Grid {
	const { positions } = mesh;
	let row = 1;
	while (3 * row + 2 < positions.length && positions[3 * row + 2] === positions[2]) row++;
	return { mesh, across: row - 1, deep: positions.length / 3 / row - 1 };
}

const finely = (cells: number): number => cells * Math.ceil(FEWEST / cells);

/** The same surface of more cells. */
function finer({ mesh, across, deep }: Grid): Grid {
	const [columns, rows] = [finely(across), finely(deep)];
	const between = (of: ArrayLike<number>, parts: number, part: number, column: number, row: number): number => {
		const [u, v] = [(column * across) / columns, (row * deep) / rows];
		const [i, j] = [Math.min(across - 1, Math.floor(u)), Math.min(deep - 1, Math.floor(v))];
		const at = (x: number, y: number) => of[parts * ((across + 1) * (j + y) + i + x) + part];
		const near = at(0, 0) + (u - i) * (at(1, 0) - at(0, 0));
		return near + (v - j) * (at(0, 1) + (u - i) * (at(1, 1) - at(0, 1)) - near);
	};
	const [positions, normals, uvs, sky, indices]: number[][] = [[], [], [], [], []];
	for (let row = 0; row <= rows; row++)
		for (let column = 0; column <= columns; column++) {
			for (let k = 0; k < 3; k++) positions.push(between(mesh.positions, 3, k, column, row));
			const way = [0, 1, 2].map((k) => between(mesh.normals, 3, k, column, row));
			const length = Math.hypot(...way) || 1;
			normals.push(...way.map((value) => value / length));
			uvs.push(positions[positions.length - 3], positions[positions.length - 1]);
			sky.push(mesh.sky ? between(mesh.sky, 1, 0, column, row) : 255);
			if (row === rows || column === columns) continue;
			const corner = (columns + 1) * row + column;
			const below = corner + columns + 1;
			indices.push(corner, below, corner + 1, corner + 1, below, below + 1);
		}
	const made = {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.from(indices),
		sky: Uint8Array.from(sky),
	};
	return { mesh: made, across: columns, deep: rows };
}

/** Once round the ground, so that what lies out is at the left hand of who goes: each corner with several ways out. */
function brinksOf({ across, deep }: Grid): Brink[] {
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

function mottled(places: readonly number[], short: number): Float32Array {
	const scale = MOTTLES / short;
	return Float32Array.from({ length: places.length / 3 }, (_, v) => {
		const [x, z] = [scale * places[3 * v], scale * places[3 * v + 2]];
		const light = 0.5 * noise(x, 0, z) + 0.3 * noise(2.3 * x, 1, 2.3 * z) + 0.2 * hashFraction(v, 5);
		return 1 + CONTRAST * (2 * light - 1);
	});
}
