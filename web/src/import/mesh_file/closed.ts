/**
 * Converts a file's triangles into a boundary: welded, simplified and scaled to height 1, with its base in the middle
 * of the ground.
 */
import { type ClosedMesh, MAX_TRIANGLES } from "../../specimen/closed_mesh";
import { text } from "../messages.generated";
import { MeshFileError, type Soup } from "./soup";

/** Larger than any number of points; its square is an exact number. */
const EDGE = 2 ** 26;
/** Larger than the number of cells per side (1 / WELDS[0]); its cube is an exact number. */
const ALONG = 2 ** 17;
/** Welding distances, as shares of the mesh's size; the first one that leaves no open edge is used. */
const WELDS = [1e-5, 1e-4, 1e-3];
/** Cells along the longest side at the first attempt to simplify; each further attempt has a quarter fewer. */
const FINEST = 64;
/** Largest coordinate for which sums and cubes stay finite. */
const FARTHEST = 1e30;
/** Rounding of coordinates, as a share of the height. */
const DECIMALS = 1e4;
/** Least volume, as a share of the height's cube: less than a needle as thin as the rounding. */
const LEAST_VOLUME = 1e-9;

/**
 * Welds, simplifies and scales a file's triangles, and turns them so that they face outwards.
 * @throws MeshFileError if the mesh has no inside: it is empty, flat, open or encloses nothing
 */
export function closedMesh(soup: Soup): ClosedMesh {
	if (soup.triangles.length === 0) throw new MeshFileError(text.message("mesh_without_triangles"));
	const size = sizeOf(soup);
	if (!(size > 0)) throw new MeshFileError(text.message("mesh_without_size"));
	if (!(farthestOf(soup) < FARTHEST)) throw new MeshFileError(text.message("mesh_too_far"));
	heightOf(soup);
	const mesh = normalise(simplify(weldedShut(soup, size), size));
	const volume = volumeOf(mesh);
	if (Math.abs(volume) < LEAST_VOLUME) throw new MeshFileError(text.message("mesh_encloses_nothing"));
	return volume > 0 ? mesh : reverseTriangles(mesh);
}

/**
 * Merges points that nearly coincide, by the first of the `WELDS` distances that leaves no open edge.
 * @param size longest side of the mesh
 * @throws MeshFileError with the number of open edges, if every distance leaves some
 */
function weldedShut(soup: Soup, size: number): Soup {
	for (const share of WELDS) {
		const welded = mergeCells(soup, share * size);
		if (openEdges(welded) === 0) return welded;
	}
	const count = openEdges(mergeCells(soup, WELDS[0] * size));
	throw new MeshFileError(text.message("mesh_open", { count }));
}

/**
 * Counts edges with an odd number of triangles; a mesh without any has an inside. An edge's key is a · EDGE + b, with a
 * and b the indices of its points, the smaller one first.
 */
function openEdges({ triangles }: Soup): number {
	const odd = new Set<number>();
	triangles.forEach((a, i) => {
		const b = triangles[i % 3 === 2 ? i - 2 : i + 1];
		const edge = Math.min(a, b) * EDGE + Math.max(a, b);
		if (!odd.delete(edge)) odd.add(edge);
	});
	return odd.size;
}

/** Returns the least and the greatest coordinate of a mesh along each axis. */
function boxOf({ points }: Soup): { low: number[]; high: number[] } {
	const low = [Infinity, Infinity, Infinity];
	const high = [-Infinity, -Infinity, -Infinity];
	for (let i = 0; i < points.length; i++) {
		low[i % 3] = Math.min(low[i % 3], points[i]);
		high[i % 3] = Math.max(high[i % 3], points[i]);
	}
	return { low, high };
}

/** Returns the longest side of the bounding box. */
function sizeOf(soup: Soup): number {
	const { low, high } = boxOf(soup);
	return Math.max(...high.map((value, k) => value - low[k]));
}

/** Returns the largest absolute value of any coordinate. */
function farthestOf(soup: Soup): number {
	const { low, high } = boxOf(soup);
	return Math.max(...low.map(Math.abs), ...high.map(Math.abs));
}

/**
 * Merges the points of each grid cell into their mean and removes degenerate triangles. A closed mesh stays closed:
 * every edge keeps as many triangles on one side as on the other.
 * @param cell side of a grid cell, in the mesh's units
 */
function mergeCells({ points, triangles }: Soup, cell: number): Soup {
	const first = boxOf({ points, triangles }).low.map((value) => Math.round(value / cell));
	const cellAlong = (i: number, k: number) => Math.round(points[3 * i + k] / cell) - first[k];
	const cells = new Map<number, number>();
	const sums: number[] = [];
	const counts: number[] = [];
	const newIndex = Array.from({ length: points.length / 3 }, (_, i) => {
		const key = (cellAlong(i, 0) * ALONG + cellAlong(i, 1)) * ALONG + cellAlong(i, 2);
		const index = cells.get(key) ?? counts.length;
		if (index === counts.length) {
			cells.set(key, index);
			sums.push(0, 0, 0);
			counts.push(0);
		}
		for (let k = 0; k < 3; k++) sums[3 * index + k] += points[3 * i + k];
		counts[index]++;
		return index;
	});
	const remaining: number[] = [];
	for (let i = 0; i < triangles.length; i += 3) {
		const [a, b, c] = [newIndex[triangles[i]], newIndex[triangles[i + 1]], newIndex[triangles[i + 2]]];
		if (a !== b && b !== c && c !== a) remaining.push(a, b, c);
	}
	return { points: sums.map((sum, i) => sum / counts[Math.floor(i / 3)]), triangles: remaining };
}

/**
 * Merges the points of ever larger cells until at most MAX_TRIANGLES triangles are left.
 * @param size longest side of the mesh
 */
function simplify(mesh: Soup, size: number): Soup {
	let simple = mesh;
	for (let cells = FINEST; simple.triangles.length > 3 * MAX_TRIANGLES; cells *= 0.75) {
		simple = mergeCells(mesh, size / cells);
	}
	return simple;
}

/**
 * Returns the signed volume, the sum of the tetrahedra between the origin and each triangle; negative if the triangles
 * face inwards.
 */
function volumeOf({ points, triangles }: Soup): number {
	let volume = 0;
	for (let i = 0; i < triangles.length; i += 3) {
		const [a, b, c] = [0, 1, 2].map((k) => points.slice(3 * triangles[i + k], 3 * triangles[i + k] + 3));
		volume +=
			a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
	}
	return volume / 6;
}

/** Reverses the triangles' orientation: swaps the second and the third corner of each. */
function reverseTriangles({ points, triangles }: Soup): Soup {
	return { points, triangles: triangles.map((_, i) => triangles[i % 3 === 1 ? i + 1 : i % 3 === 2 ? i - 1 : i]) };
}

/** Returns the height of a mesh; throws a MeshFileError if it is flat. */
function heightOf(soup: Soup): number {
	const { low, high } = boxOf(soup);
	if (high[1] > low[1]) return high[1] - low[1];
	throw new MeshFileError(text.message("mesh_flat"));
}

/** Moves a mesh onto the ground, its middle over the origin, and scales it to a height of 1. */
function normalise({ points, triangles }: Soup): ClosedMesh {
	const { low, high } = boxOf({ points, triangles });
	const height = heightOf({ points, triangles });
	const origin = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2];
	const coordinate = (value: number, k: number) => Math.round(((value - origin[k]) / height) * DECIMALS) / DECIMALS + 0;
	return { points: points.map((value, i) => coordinate(value, i % 3)), triangles };
}
