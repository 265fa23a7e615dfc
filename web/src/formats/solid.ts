/** A plant as one closed body for printers, with a least thickness. */
import { MeshoptSimplifier } from "meshoptimizer/simplifier";
import type { Part } from "../plant/part";
import { EmptyPlantError } from "./file_error";
import { isClosed } from "./hidden";
import { text } from "./messages.generated";
import { fillHollows, joinPieces } from "./one_body";
import { boundsOf, piecesOf } from "./piece";
import { type Surface, surfaceOf } from "./surface_nets";
import { emptyVoxels, fillInside, fillThin, thicken, withoutPinches } from "./voxels";

/** Cells per least thickness; smoothing takes half a cell of them (surface_nets.ts). */
const THICK = 2;
const SMOOTHED_THICKNESS = THICK - 0.5;
/** The most cells, which fit the memory of phones; beyond it cells become coarser, and the least thickness larger. */
const MAX_CELLS = 16_000_000;
/** The size of printers' beds, metres: larger plants are written at the first of these scales that fits. */
const LONGEST = 0.25;
const SCALES = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
/** How often vertices are locked where simplification would tear the surface. */
const ATTEMPTS = 2;
/** Pieces farther apart than this are not joined, metres of the print: longer rods would be visible. */
const FARTHEST = 0.005;
/** The largest movement of the surface in simplification, in cells. */
const SLACK = 0.15;

export interface Solid extends Surface {
	/** 1 for life size, 50 for 1:50. Positions are in metres of the print. */
	scale: number;
	/**
	 * The least thickness, metres of the print: the requested one, or more where the body is too large for so fine a
	 * grid.
	 */
	thickness: number;
	/** The number of loose pieces, which were left out. */
	loose: number;
}

/**
 * Returns the plant as one body without hollows.
 * @param least metres of the print
 * @throws EmptyPlantError where the plant has no mesh
 */
export async function solidOf(parts: Iterable<Part>, least: number): Promise<Solid> {
	await MeshoptSimplifier.ready;
	const meshes = [...piecesOf(parts)].map(({ mesh }) => mesh);
	if (!meshes.some(({ indices }) => indices.length > 0)) throw new EmptyPlantError();
	const life = boundsOf(meshes.map(({ positions }) => positions));
	const extents = life.high.map((value, k) => value - life.low[k]);
	const scale = SCALES.find((each) => Math.max(...extents) / each <= LONGEST) ?? SCALES[SCALES.length - 1];
	const printed = meshes.map((mesh) => ({ ...mesh, positions: mesh.positions.map((value) => value / scale) }));
	const { low, high } = boundsOf(printed.map(({ positions }) => positions));
	const pitch = pitchFor(
		extents.map((value) => value / scale),
		least / SMOOTHED_THICKNESS,
	);
	const voxels = emptyVoxels(low, high, pitch);
	fillInside(voxels, printed.filter(closedOnce()));
	fillThin(voxels, printed);
	thicken(voxels, THICK);
	withoutPinches(voxels);
	const loose = joinPieces(voxels, THICK, Math.ceil(FARTHEST / pitch));
	withoutPinches(voxels);
	fillHollows(voxels);
	const surface = fewer(surfaceOf(voxels), SLACK * pitch);
	return { ...surface, scale, thickness: SMOOTHED_THICKNESS * pitch, loose };
}

/**
 * Differences from the request, in sentences.
 * @param least as in `solidOf`
 */
export function solidNotes({ thickness, loose }: Pick<Solid, "thickness" | "loose">, least: number): string[] {
	const notes: string[] = [];
	const millimetres = (metres: number) => Number((1000 * metres).toPrecision(2));
	if (thickness > 1.01 * least) {
		notes.push(text("solid_thicker", { used: millimetres(thickness), wanted: millimetres(least) }));
	}
	if (loose > 0) {
		notes.push(text("solid_loose", { count: loose, distance: millimetres(FARTHEST) }));
	}
	return notes;
}

/** Returns the edge of a cell: `wanted`, or the least that keeps the grid within its limit. */
function pitchFor([x, y, z]: readonly number[], wanted: number): number {
	let pitch = wanted;
	const cells = () => [x, y, z].reduce((product, extent) => product * (extent / pitch + 8), 1);
	while (cells() > MAX_CELLS) pitch *= 1.05;
	return pitch;
}

/** Returns a function that checks whether a mesh is closed, with a cache by its triangles. */
function closedOnce(): (mesh: Parameters<typeof isClosed>[0]) => boolean {
	const known = new Map<Uint32Array, boolean>();
	return (mesh) => {
		const closed = known.get(mesh.indices) ?? isClosed(mesh);
		known.set(mesh.indices, closed);
		return closed;
	};
}

/**
 * Simplifies a mesh. The surface stays as it is around edges that would get more than two triangles; the whole surface
 * stays if all attempts tear it.
 * @param error the largest movement of the surface, in its units
 */
function fewer(surface: Surface, error: number): Surface {
	const { positions, indices } = surface;
	const vertices = positions.length / 3;
	const locked = new Uint8Array(vertices);
	for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
		const [simple] = MeshoptSimplifier.simplifyWithAttributes(
			indices,
			positions,
			3,
			new Float32Array(vertices),
			1,
			[0],
			locked,
			0,
			error,
			["ErrorAbsolute"],
		);
		const torn = tornAt(simple);
		if (torn.size === 0) return compacted(positions, simple);
		for (let at = 0; at < indices.length; at += 3) {
			const corners = indices.subarray(at, at + 3);
			if (corners.some((vertex) => torn.has(vertex))) for (const vertex of corners) locked[vertex] = 1;
		}
	}
	return surface;
}

/** Returns the mesh of some triangles, without unused vertices. */
function compacted(positions: Float32Array, indices: Uint32Array): Surface {
	const [remap, count] = MeshoptSimplifier.compactMesh(indices);
	const own = new Float32Array(3 * count);
	for (const [from, to] of remap.entries()) {
		if (to < count) own.set(positions.subarray(3 * from, 3 * from + 3), 3 * to);
	}
	return { positions: own, indices };
}

/**
 * Returns the vertices at edges without exactly two triangles in opposite directions. The edges are first sorted by
 * their first vertex (counting sort).
 */
export function tornAt(indices: Uint32Array): Set<number> {
	const next = (at: number) => indices[at % 3 === 2 ? at - 2 : at + 1];
	// Ends of the edges from each vertex, one vertex after the other.
	const firsts = new Uint32Array(indices.reduce((most, vertex) => Math.max(most, vertex), 0) + 3);
	for (const vertex of indices) firsts[vertex + 2]++;
	for (let vertex = 2; vertex < firsts.length; vertex++) firsts[vertex] += firsts[vertex - 1];
	const ends = new Uint32Array(indices.length);
	for (let at = 0; at < indices.length; at++) ends[firsts[indices[at] + 1]++] = next(at);
	const count = (from: number, to: number) => {
		let found = 0;
		for (let at = firsts[from]; at < firsts[from + 1]; at++) if (ends[at] === to) found++;
		return found;
	};
	const torn = new Set<number>();
	for (let at = 0; at < indices.length; at++) {
		const [from, to] = [indices[at], next(at)];
		if (count(from, to) !== 1 || count(to, from) !== 1) torn.add(from).add(to);
	}
	return torn;
}
