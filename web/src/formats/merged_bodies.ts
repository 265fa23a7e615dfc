/**
 * Merges touching solid bodies, such as the berries of a bunch, into one surface: for budgets of triangles that are too
 * small for each body by itself.
 */
import type { Material } from "../plant/material";
import type { PartMesh } from "../plant/part";
import { isClosed } from "./hidden";
import { fillHollows } from "./one_body";
import { boundsOf, extentOf, type Piece } from "./piece";
import { PointTree } from "./point_tree";
import { surfaceOf } from "./surface_nets";
import { plainBase } from "./vertex_colours";
import { closeGaps, emptyVoxels, fillInside, withoutPinches } from "./voxels";

/** Cells along the longest edge of the plant. */
const CELLS = 192;
/**
 * Bodies thinner than this keep their triangles: in cells, the radius of the ball with the same ratio of volume to
 * surface.
 */
const LEAST_RADIUS = 2;

/** Solid pieces by material, where a material has two or more. */
export type SolidGroups = ReadonlyMap<Material, readonly Piece[]>;

/**
 * Finds solid pieces: closed and not thin, without pictures and fixed points (`feet`), unlike leaves, petals or
 * pedicels.
 */
export function solidGroups(pieces: readonly Piece[]): SolidGroups {
	const least = LEAST_RADIUS * pitchFor(pieces);
	const groups = new Map<Material, Piece[]>();
	for (const piece of pieces) {
		if (!isSolid(piece, least)) continue;
		const group = groups.get(piece.material);
		if (group) group.push(piece);
		else groups.set(piece.material, [piece]);
	}
	return new Map([...groups].filter(([, group]) => group.length > 1));
}

/**
 * Returns the pieces, with each group of solid ones merged into one closed piece, with new normals and the colours of
 * the nearest original vertices.
 * @param groups of these pieces
 * @param reach half the width of gaps between bodies that are filled, in 192nds of the longest edge of the plant
 */
export function mergedBodies(pieces: readonly Piece[], groups: SolidGroups, reach: number): Piece[] {
	const merged = new Set([...groups.values()].flat());
	const pitch = pitchFor(pieces);
	const bodies = [...groups].map(([material, group]) => ({ material, mesh: bodyOf(group, pitch, reach) }));
	return [...bodies, ...pieces.filter((piece) => !merged.has(piece))];
}

/** Returns the edge of a cell: the plant's longest edge divided by `CELLS`. */
const pitchFor = (pieces: readonly Piece[]) => extentOf(pieces) / CELLS;

/** Returns whether a piece may be merged: closed, not thinner than `leastRadius`, and a plain solid material. */
function isSolid({ material, mesh }: Piece, leastRadius: number): boolean {
	if (material.textures || material.doubleSided || material.sheet || mesh.feet) return false;
	return radiusOf(mesh) >= leastRadius && isClosed(mesh);
}

/** Returns three times the volume divided by the surface: the radius of a ball; 0 for a mesh without triangles. */
function radiusOf({ positions, indices }: PartMesh): number {
	let [volume, area] = [0, 0];
	for (let at = 0; at < indices.length; at += 3) {
		const a = 3 * indices[at];
		const [x, y, z] = crossOf(positions, a, 3 * indices[at + 1], 3 * indices[at + 2]);
		volume += positions[a] * x + positions[a + 1] * y + positions[a + 2] * z;
		area += Math.hypot(x, y, z);
	}
	return area > 0 ? volume / area : 0;
}

/**
 * Merges pieces of one material into one closed mesh, by voxels: gaps up to twice `reach` cells wide are closed,
 * hollows filled, and the surface extracted by surface nets.
 * @param pitch edge of a cell, metres
 */
function bodyOf(pieces: readonly Piece[], pitch: number, reach: number): PartMesh {
	const meshes = pieces.map(({ mesh }) => mesh);
	const { low, high } = boundsOf(meshes.map(({ positions }) => positions));
	const voxels = emptyVoxels(low, high, pitch, reach + 2);
	fillInside(voxels, meshes);
	closeGaps(voxels, reach);
	withoutPinches(voxels);
	fillHollows(voxels);
	const { positions, indices } = surfaceOf(voxels);
	const colours = coloursAt(positions, pieces);
	const mesh = { positions, normals: normalsOf(positions, indices), uvs: new Float32Array(0), indices };
	return colours ? { ...mesh, colours } : mesh;
}

/** Computes vertex normals: means over the adjacent triangles, weighted by area. */
function normalsOf(positions: Float32Array, indices: Uint32Array): Float32Array {
	const normals = new Float32Array(positions.length);
	for (let at = 0; at < indices.length; at += 3) {
		const corners = [3 * indices[at], 3 * indices[at + 1], 3 * indices[at + 2]];
		const normal = crossOf(positions, corners[0], corners[1], corners[2]);
		for (const corner of corners) for (let k = 0; k < 3; k++) normals[corner + k] += normal[k];
	}
	for (let at = 0; at < normals.length; at += 3) {
		const length = Math.hypot(normals[at], normals[at + 1], normals[at + 2]);
		if (length > 0) for (let k = 0; k < 3; k++) normals[at + k] /= length;
		else normals[at + 1] = 1;
	}
	return normals;
}

/**
 * Returns the cross product of two edges of a triangle: a vector along its normal, as long as twice its area.
 * @param p positions, 3 × vertices
 * @param a @param b @param c offsets of its corners' positions
 */
function crossOf(p: Float32Array, a: number, b: number, c: number): [x: number, y: number, z: number] {
	const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
	const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
	return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

/** Returns the colours of the nearest vertices; undefined where no piece has vertex colours. */
function coloursAt(positions: Float32Array, pieces: readonly Piece[]): Float32Array | undefined {
	if (!pieces.some(({ mesh }) => mesh.colours)) return undefined;
	const length = pieces.reduce((sum, { mesh }) => sum + mesh.positions.length, 0);
	const [points, known] = [new Float32Array(length), new Float32Array(length)];
	let first = 0;
	for (const { mesh, material } of pieces) {
		points.set(mesh.positions, first);
		const base = plainBase(material);
		known.set(mesh.colours ?? mesh.positions.map((_, i) => base[i % 3]), first);
		first += mesh.positions.length;
	}
	const tree = new PointTree(points);
	const colours = new Float32Array(positions.length);
	for (let at = 0; at < positions.length; at += 3) {
		const nearest = tree.nearest(positions[at], positions[at + 1], positions[at + 2]);
		for (let k = 0; k < 3; k++) colours[at + k] = known[3 * nearest + k];
	}
	return colours;
}
