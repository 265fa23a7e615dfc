/**
 * Fewer triangles for the same look, by meshoptimizer: edges collapse where that changes shape, light and colour least.
 */
import { type Flags, MeshoptSimplifier } from "meshoptimizer/simplifier";
import { clamp } from "../plant/colour";
import type { PartMesh } from "../plant/part";
import type { Piece } from "./piece";
import { welded } from "./weld";

/**
 * The weight of differences of normals and of colours, as a share of the whole plant's extent: an error of a tenth in a
 * normal counts as much as an error of a two-thousandth in position.
 */
const NORMAL_WEIGHT = 0.005;
const COLOUR_WEIGHT = 0.02;
/** Numbers besides the position that collapses consider: a normal and a colour. */
const ATTRIBUTES = 6;
const WEIGHTS = [...new Array(3).fill(NORMAL_WEIGHT), ...new Array(3).fill(COLOUR_WEIGHT)];
/**
 * Rounding within which vertices count as equal: eighths of a degree, colours as files have them, a 4096th of a
 * picture.
 */
const NORMAL_STEPS = 512;
const COLOUR_STEPS = 255;
const PICTURE_STEPS = 4096;

export interface SimplifyOptions {
	/** The most triangles; the least important ones go first. Without it only as many go as `error` allows. */
	triangles?: number;
	/** The largest movement of a surface, as a share of the plant's extent; unlimited where absent. */
	error?: number;
	/**
	 * Whether vertices may move to reduce the error of the surface, with their normals and colours. Triangles between
	 * fixed vertices lie inside convex surfaces. Has no effect where a piece has texture coordinates or `feet`.
	 */
	moves?: boolean;
}

/** Returns the pieces with fewer vertices and triangles, simplified together; empty ones are left out. */
export async function simplified(
	pieces: readonly Piece[],
	{ triangles = 0, error = 1, moves = false }: SimplifyOptions,
): Promise<Piece[]> {
	await MeshoptSimplifier.ready;
	const joined = concatenate(pieces.map(({ mesh }) => mergeVertices(mesh)));
	const target = 3 * triangles;
	let indices = joined.indices;
	if (indices.length > target && indices.length > 0) {
		const { positions, attributes } = joined;
		const flags: Flags[] = ["Prune"];
		const request = [indices, positions, 3, attributes, ATTRIBUTES, WEIGHTS, null, target, error, flags] as const;
		// Moved vertices give better shapes, but texture coordinates and fixed points would stay behind.
		if (moves && pieces.every(({ mesh }) => mesh.uvs.length === 0 && !mesh.feet)) {
			const [corners] = MeshoptSimplifier.simplifyWithUpdate(...request);
			indices = indices.slice(0, corners);
			joined.meshes = joined.meshes.map((mesh, i) => withMovedVertices(mesh, joined, joined.firsts[i]));
		} else {
			[indices] = MeshoptSimplifier.simplifyWithAttributes(...request);
		}
		// Meshes with too many connections are simplified on a grid.
		if (triangles > 0 && indices.length > target)
			[indices] = MeshoptSimplifier.simplifySloppy(indices, joined.positions, 3, null, target, 1);
	}
	const parts = divide(indices, joined.firsts);
	return pieces.flatMap(({ material }, i) =>
		parts[i].length > 0 ? [{ material, mesh: compact(joined.meshes[i], parts[i]) }] : [],
	);
}

/** Merges equal vertices. */
function mergeVertices(mesh: PartMesh): PartMesh {
	const { normals, uvs, colours } = mesh;
	const steps = (values: Float32Array, step: number) =>
		Int32Array.from(values.map((value) => Math.round(value * step)));
	const rows = [steps(normals, NORMAL_STEPS), steps(uvs, PICTURE_STEPS)];
	if (colours) rows.push(steps(colours, COLOUR_STEPS));
	const { indices, from } = welded(mesh, ...rows);
	return { ...taken(mesh, from), indices };
}

interface Whole {
	meshes: PartMesh[];
	/** The first vertex of each mesh, and the end of the last. */
	firsts: number[];
	positions: Float32Array;
	attributes: Float32Array;
	indices: Uint32Array;
}

/** Joins meshes into one, with the attributes that simplification weighs: normals and colours. */
function concatenate(meshes: PartMesh[]): Whole {
	const firsts = [0];
	for (const { positions } of meshes) firsts.push(firsts[firsts.length - 1] + positions.length / 3);
	const vertices = firsts[meshes.length];
	const positions = new Float32Array(3 * vertices);
	const attributes = new Float32Array(ATTRIBUTES * vertices);
	const indices = new Uint32Array(meshes.reduce((sum, mesh) => sum + mesh.indices.length, 0));
	let corner = 0;
	for (const [i, mesh] of meshes.entries()) {
		positions.set(mesh.positions, 3 * firsts[i]);
		for (let vertex = 0; vertex < mesh.positions.length / 3; vertex++) {
			const at = ATTRIBUTES * (firsts[i] + vertex);
			attributes.set(mesh.normals.subarray(3 * vertex, 3 * vertex + 3), at);
			if (mesh.colours) attributes.set(mesh.colours.subarray(3 * vertex, 3 * vertex + 3), at + 3);
		}
		for (const index of mesh.indices) indices[corner++] = index + firsts[i];
	}
	return { meshes, firsts, positions, attributes, indices };
}

/** Returns a mesh with the positions, normals and colours of its vertices in the whole, from the vertex `first` on. */
function withMovedVertices(mesh: PartMesh, { positions, attributes }: Whole, first: number): PartMesh {
	const [normals, colours] = [new Float32Array(mesh.positions.length), new Float32Array(mesh.positions.length)];
	for (let to = 0, at = ATTRIBUTES * first; to < normals.length; to += 3, at += ATTRIBUTES) {
		const length = Math.hypot(attributes[at], attributes[at + 1], attributes[at + 2]);
		for (let k = 0; k < 3; k++) {
			normals[to + k] = length > 0 ? attributes[at + k] / length : mesh.normals[to + k];
			colours[to + k] = clamp(attributes[at + 3 + k]);
		}
	}
	const movedMesh = { ...mesh, positions: positions.slice(3 * first, 3 * first + normals.length), normals };
	return mesh.colours ? { ...movedMesh, colours } : movedMesh;
}

/**
 * Splits triangles of the joined mesh into those of each mesh, by its own vertices.
 * @param firsts the first vertex of each mesh
 */
function divide(indices: Uint32Array, firsts: readonly number[]): number[][] {
	const triangles: number[][] = firsts.slice(1).map(() => []);
	for (let at = 0; at < indices.length; at += 3) {
		let mesh = 0;
		while (indices[at] >= firsts[mesh + 1]) mesh++;
		triangles[mesh].push(indices[at] - firsts[mesh], indices[at + 1] - firsts[mesh], indices[at + 2] - firsts[mesh]);
	}
	return triangles;
}

/** Returns the mesh with these triangles, without unused vertices. */
function compact(mesh: PartMesh, triangles: readonly number[]): PartMesh {
	const from: number[] = [];
	const to = new Int32Array(mesh.positions.length / 3).fill(-1);
	const indices = Uint32Array.from(triangles, (vertex) => {
		if (to[vertex] < 0) to[vertex] = from.push(vertex) - 1;
		return to[vertex];
	});
	return { ...taken(mesh, Uint32Array.from(from)), indices };
}

/** Returns the vertices `from` of a mesh, in that order. */
export function taken(mesh: PartMesh, from: Uint32Array): PartMesh {
	const valuesOf = (values: Float32Array, width: number) => {
		if (values.length === 0) return values;
		const selected = new Float32Array(width * from.length);
		for (const [to, vertex] of from.entries())
			for (let k = 0; k < width; k++) selected[width * to + k] = values[width * vertex + k];
		return selected;
	};
	const { positions, normals, uvs, indices, colours, feet, name } = mesh;
	return {
		positions: valuesOf(positions, 3),
		normals: valuesOf(normals, 3),
		uvs: valuesOf(uvs, 2),
		indices,
		...(colours ? { colours: valuesOf(colours, 3) } : {}),
		...(feet ? { feet: valuesOf(feet, 3) } : {}),
		...(name === undefined ? {} : { name }),
	};
}
