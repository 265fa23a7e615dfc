/**
 * Converts a file's triangles into a boundary: welded, simplified and scaled to height 1, with its base in the middle
 * of the ground.
 */
import { type ClosedMesh, MOST_TRIANGLES } from "../../specimen/closed_mesh";
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

/** @throws MeshFileError if the mesh has no inside: it is empty, flat, open or encloses nothing */
export function closedMesh(soup: Soup): ClosedMesh {
	if (soup.triangles.length === 0) throw new MeshFileError("The file holds no triangles.");
	const size = sizeOf(soup);
	if (!(size > 0)) throw new MeshFileError("The mesh has no size.");
	if (!(farthestOf(soup) < FARTHEST)) throw new MeshFileError("The mesh reaches beyond 10³⁰ units: scale it down.");
	heightOf(soup);
	const mesh = framed(simplified(weldedShut(soup, size), size));
	const volume = volumeOf(mesh);
	if (Math.abs(volume) < LEAST_VOLUME) throw new MeshFileError("The mesh encloses nothing: it has no inside.");
	return volume > 0 ? mesh : turned(mesh);
}

function weldedShut(soup: Soup, size: number): Soup {
	for (const share of WELDS) {
		const welded = merged(soup, share * size);
		if (openEdges(welded) === 0) return welded;
	}
	const open = openEdges(merged(soup, WELDS[0] * size));
	const edges = open === 1 ? "1 of its edges has" : `${open.toLocaleString("en")} of its edges have`;
	throw new MeshFileError(
		`The mesh is not closed: ${edges} a triangle at one side only. Fill its holes where it was made, and bring it again.`,
	);
}

/** Counts edges with an odd number of triangles; without any, the mesh has an inside. */
function openEdges({ triangles }: Soup): number {
	const odd = new Set<number>();
	triangles.forEach((a, i) => {
		const b = triangles[i % 3 === 2 ? i - 2 : i + 1];
		const edge = Math.min(a, b) * EDGE + Math.max(a, b);
		if (!odd.delete(edge)) odd.add(edge);
	});
	return odd.size;
}

function boxOf({ points }: Soup): { low: number[]; high: number[] } {
	const low = [Infinity, Infinity, Infinity];
	const high = [-Infinity, -Infinity, -Infinity];
	for (let i = 0; i < points.length; i++) {
		low[i % 3] = Math.min(low[i % 3], points[i]);
		high[i % 3] = Math.max(high[i % 3], points[i]);
	}
	return { low, high };
}

function sizeOf(soup: Soup): number {
	const { low, high } = boxOf(soup);
	return Math.max(...high.map((value, k) => value - low[k]));
}

/** The largest coordinate, of either sign. */
function farthestOf(soup: Soup): number {
	const { low, high } = boxOf(soup);
	return Math.max(...low.map(Math.abs), ...high.map(Math.abs));
}

/**
 * Merges the points of each grid cell into their mean and removes degenerate triangles. A closed mesh stays closed:
 * every edge keeps as many triangles on one side as on the other.
 */
function merged({ points, triangles }: Soup, cell: number): Soup {
	const first = boxOf({ points, triangles }).low.map((value) => Math.round(value / cell));
	const along = (i: number, k: number) => Math.round(points[3 * i + k] / cell) - first[k];
	const cells = new Map<number, number>();
	const sums: number[] = [];
	const counts: number[] = [];
	const into = Array.from({ length: points.length / 3 }, (_, i) => {
		const key = (along(i, 0) * ALONG + along(i, 1)) * ALONG + along(i, 2);
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
		const [a, b, c] = [into[triangles[i]], into[triangles[i + 1]], into[triangles[i + 2]]];
		if (a !== b && b !== c && c !== a) remaining.push(a, b, c);
	}
	return { points: sums.map((sum, i) => sum / counts[Math.floor(i / 3)]), triangles: remaining };
}

function simplified(mesh: Soup, size: number): Soup {
	let simple = mesh;
	for (let cells = FINEST; simple.triangles.length > 3 * MOST_TRIANGLES; cells *= 0.75) {
		simple = merged(mesh, size / cells);
	}
	return simple;
}

/** Signed volume; negative if the triangles face inwards. */
function volumeOf({ points, triangles }: Soup): number {
	let volume = 0;
	for (let i = 0; i < triangles.length; i += 3) {
		const [a, b, c] = [0, 1, 2].map((k) => points.slice(3 * triangles[i + k], 3 * triangles[i + k] + 3));
		volume +=
			a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
	}
	return volume / 6;
}

/** Reverses the triangles' orientation. */
function turned({ points, triangles }: Soup): Soup {
	return { points, triangles: triangles.map((_, i) => triangles[i % 3 === 1 ? i + 1 : i % 3 === 2 ? i - 1 : i]) };
}

function heightOf(soup: Soup): number {
	const { low, high } = boxOf(soup);
	if (high[1] > low[1]) return high[1] - low[1];
	throw new MeshFileError("The mesh is flat: it has no inside.");
}

function framed({ points, triangles }: Soup): ClosedMesh {
	const { low, high } = boxOf({ points, triangles });
	const height = heightOf({ points, triangles });
	const from = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2];
	const place = (value: number, k: number) => Math.round(((value - from[k]) / height) * DECIMALS) / DECIMALS + 0;
	return { points: points.map((value, i) => place(value, i % 3)), triangles };
}
