/**
 * Encodes a grown leaf for attachment to other plants: flat, simplified, its veins in one small picture
 * (plant/leaf.ts).
 */
import { deflateSync } from "fflate";
import { writeContainer } from "../../../core/container";
import { type LeafFile, STEEPS, STEPS } from "../../../plant/leaf";
import { lightMesh } from "../bake/light_mesh";
import type { Leaf } from "../grown";
import { veinRaster } from "../parts/vein_raster";
import type { LeafSpecimen } from "../specimen";
import { sparseBlade } from "./sparse_blade";

export interface AttachedLeafOptions {
	/** Resolution of the mesh: cells along a side of the blade's square, each with at most one vertex. */
	cells?: number;
	/**
	 * In place of `cells`, for thousands of leaves: corners of each half's margin. Such leaves include their petiole.
	 */
	corners?: number;
	/** Width and height of the picture of the veins, pixels; no picture where absent. */
	pixels?: number;
}

/** Shades of grey in the picture of the veins. */
const SHADES = 16;
/**
 * Least relative width of veins that pucker the blade, and the distance from them at which the blade is highest, in
 * leaf lengths.
 */
const [PUCKERING, MIDST] = [0.16, 0.1];
/** Least relative width of veins in the picture. */
const SEEN = 0.06;

/**
 * @param from the preset that the leaf grew from
 * @throws Error where the leaf was grown without meshes
 */
export function encodeAttachedLeaf(
	leaf: Leaf,
	{ parameters }: LeafSpecimen,
	from: string,
	options: AttachedLeafOptions,
): LeafFile {
	const { left, bottom, size } = leaf.square;
	const { corners, pixels } = options;
	const { uvs, indices } = corners ? sparse(leaf, corners) : fine(leaf, options.cells ?? 0);
	const points = uvs.map((value, at) => (at % 2 === 0 ? left : bottom) + size * value);
	const petiole = Float32Array.of(parameters.petiole / 100, parameters.petiole_width / parameters.length);
	const container = writeContainer([
		{ name: "square", data: Float32Array.of(left, bottom, size) },
		{ name: "uvs", data: Int32Array.from(uvs, (value, at) => inSteps(at % 2 === 0 ? value : 1 - value)), width: 2 },
		{ name: "between", data: betweenVeins(leaf, points) },
		{ name: "indices", data: indices, width: 3 },
		...(corners ? [{ name: "petiole", data: petiole }] : []),
		...(pixels ? [{ name: "veins", data: picture(seenVeins(leaf), parameters.length, pixels), width: pixels }] : []),
	]);
	const packed = deflateSync(container, { level: 9, mem: 12 });
	return { from, data: btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join("")) };
}

/** A flat mesh over the leaf's chart: 2 × vertices in 0 … 1; the first vertex is the petiole's. */
interface Flat {
	uvs: Float32Array;
	indices: Uint32Array;
}

function fine(leaf: Leaf, cells: number): Flat {
	const upper = leaf.meshes.find(({ name }) => name === "upper");
	if (!upper) throw new Error("This leaf has no blade: grow it with meshes.");
	const { left, bottom, size } = leaf.square;
	return fromPetiole(lightMesh(upper, leaf.faces.upper.edge, cells), [-left / size, -bottom / size]);
}

function sparse({ margin, square: { left, bottom, size } }: Leaf, corners: number): Flat {
	const { points, indices } = sparseBlade(margin, corners);
	return { uvs: points.map((value, at) => (value - (at % 2 === 0 ? left : bottom)) / size), indices };
}

const inSteps = (value: number) => Math.round(value * STEPS);

/** Moves the vertex nearest to the petiole there, and makes it the first. */
function fromPetiole({ uvs, indices }: Flat, petiole: readonly number[]): Flat {
	const away = (vertex: number) => Math.hypot(uvs[2 * vertex] - petiole[0], uvs[2 * vertex + 1] - petiole[1]);
	let nearest = 0;
	for (let vertex = 1; 2 * vertex < uvs.length; vertex++) if (away(vertex) < away(nearest)) nearest = vertex;
	const moved = uvs.slice();
	moved.copyWithin(2 * nearest, 0, 2);
	moved.set(petiole, 0);
	const other = (vertex: number) => (vertex === nearest ? 0 : vertex === 0 ? nearest : vertex);
	return { uvs: moved, indices: indices.map(other) };
}

const widestOf = ({ segments: { radii } }: Leaf) => radii.reduce((most, radius) => Math.max(most, radius), 0);

/** Indices of the vein segments of at least a relative width. */
function veinsFrom(leaf: Leaf, share: number): number[] {
	const least = share * widestOf(leaf);
	const { count, radii } = leaf.segments;
	return Array.from({ length: count }, (_, piece) => piece).filter((piece) => radii[2 * piece + 1] >= least);
}

function betweenVeins(leaf: Leaf, points: Float32Array): Uint8Array {
	const veins = veinsFrom(leaf, PUCKERING);
	return Uint8Array.from({ length: points.length / 2 }, (_, vertex) => {
		const [x, y] = points.subarray(2 * vertex, 2 * vertex + 2);
		const nearest = veins.reduce((least, piece) => Math.min(least, distance(leaf.chart, piece, x, y)), MIDST);
		return Math.round((STEEPS * nearest) / MIDST);
	});
}

/** Distance of a point of the chart from one segment of a vein. */
function distance(chart: Float32Array, piece: number, x: number, y: number): number {
	const [x1, y1, x2, y2] = chart.subarray(4 * piece, 4 * piece + 4);
	const [dx, dy] = [x2 - x1, y2 - y1];
	const squared = dx * dx + dy * dy;
	const t = squared > 0 ? Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / squared)) : 0;
	return Math.hypot(x - x1 - t * dx, y - y1 - t * dy);
}

/** The leaf without veins that would be noise in a small picture. */
function seenVeins(leaf: Leaf): Leaf {
	const visible = veinsFrom(leaf, SEEN);
	const gathered = (values: Float32Array, width: number) =>
		Float32Array.from(visible.flatMap((piece) => [...values.subarray(width * piece, width * (piece + 1))]));
	const segments = { ...leaf.segments, count: visible.length, radii: gathered(leaf.segments.radii, 2) };
	return { ...leaf, chart: gathered(leaf.chart, 4), energy: gathered(leaf.energy, 1), segments };
}

/** The picture of the veins; its rows go down, the raster's go up. */
function picture(leaf: Leaf, millimetres: number, side: number): Uint8Array {
	const { cover } = veinRaster(leaf, millimetres, side);
	const pixels = new Uint8Array(side * side);
	for (let at = 0; at < pixels.length; at++) {
		// The square root makes thin veins, which cover little of a pixel, visible.
		const shade = Math.round((SHADES - 1) * Math.sqrt(cover[at]));
		pixels[(side - 1 - Math.floor(at / side)) * side + (at % side)] = (shade * 255) / (SHADES - 1);
	}
	return pixels;
}
