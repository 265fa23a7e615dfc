/**
 * Encodes a grown leaf for attachment to other plants: flat, simplified, its veins in one small picture
 * (plant/leaf.ts).
 */

import { deflateSync } from "fflate";
import { writeContainer } from "../../../core/container";
import { BETWEEN_STEPS, type LeafFile, UV_STEPS } from "../../../plant/leaf";
import { lightMesh } from "../bake/light_mesh";
import type { Leaf } from "../grown";
import { text } from "../messages.generated";
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
const [LEAST_PUCKERING_WIDTH, FULL_HEIGHT_DISTANCE] = [0.16, 0.1];
/** Least relative width of veins in the picture. */
const LEAST_PICTURE_WIDTH = 0.06;

/**
 * Encodes a leaf with a mesh of `corners` margin corners or of a grid of `cells`, and a picture of its veins.
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
	const { uvs, indices } = corners ? sparseMesh(leaf, corners) : gridMesh(leaf, options.cells ?? 0);
	const points = uvs.map((value, at) => (at % 2 === 0 ? left : bottom) + size * value);
	const petiole = Float32Array.of(parameters.petiole / 100, parameters.petiole_width / parameters.length);
	const container = writeContainer([
		{ name: "square", data: Float32Array.of(left, bottom, size) },
		{ name: "uvs", data: Int32Array.from(uvs, (value, at) => inSteps(at % 2 === 0 ? value : 1 - value)), width: 2 },
		{ name: "between", data: distancesFromVeins(leaf, points) },
		{ name: "indices", data: indices, width: 3 },
		...(corners ? [{ name: "petiole", data: petiole }] : []),
		...(pixels
			? [{ name: "veins", data: veinPicture(withoutThinVeins(leaf), parameters.length, pixels), width: pixels }]
			: []),
	]);
	const packed = deflateSync(container, { level: 9, mem: 12 });
	return { from, data: btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join("")) };
}

/** A flat mesh over the leaf's chart: 2 × vertices in 0 … 1; the first vertex is the petiole's. */
interface FlatMesh {
	uvs: Float32Array;
	indices: Uint32Array;
}

/** Returns a mesh with at most one vertex in each of cells × cells squares over the blade's chart. */
function gridMesh(leaf: Leaf, cells: number): FlatMesh {
	const upper = leaf.meshes.find(({ name }) => name === "upper");
	if (!upper) throw new Error(text("no_blade"));
	const { left, bottom, size } = leaf.square;
	return withPetioleFirst(lightMesh(upper, leaf.faces.upper.edge, cells), [-left / size, -bottom / size]);
}

/** Returns a mesh of few triangles, with a number of corners along each half's margin. */
function sparseMesh({ margin, square: { left, bottom, size } }: Leaf, corners: number): FlatMesh {
	const { points, indices } = sparseBlade(margin, corners);
	return { uvs: points.map((value, at) => (value - (at % 2 === 0 ? left : bottom)) / size), indices };
}

/** Converts a texture coordinate, 0 … 1, to the whole steps that the file stores. */
const inSteps = (value: number) => Math.round(value * UV_STEPS);

/**
 * Moves the vertex nearest to the petiole to it, and makes it the first vertex.
 * @param petiole texture coordinates u, v
 */
function withPetioleFirst({ uvs, indices }: FlatMesh, petiole: readonly number[]): FlatMesh {
	const distanceTo = (vertex: number) => Math.hypot(uvs[2 * vertex] - petiole[0], uvs[2 * vertex + 1] - petiole[1]);
	let nearest = 0;
	for (let vertex = 1; 2 * vertex < uvs.length; vertex++)
		if (distanceTo(vertex) < distanceTo(nearest)) nearest = vertex;
	const reordered = uvs.slice();
	reordered.copyWithin(2 * nearest, 0, 2);
	reordered.set(petiole, 0);
	const newIndex = (vertex: number) => (vertex === nearest ? 0 : vertex === 0 ? nearest : vertex);
	return { uvs: reordered, indices: indices.map(newIndex) };
}

/** Returns the largest radius of a vein. */
const largestRadius = ({ segments: { radii } }: Leaf) => radii.reduce((most, radius) => Math.max(most, radius), 0);

/** Returns the indices of the vein segments whose radius is at least a share of the largest radius. */
function indicesOfWideVeins(leaf: Leaf, share: number): number[] {
	const least = share * largestRadius(leaf);
	const { count, radii } = leaf.segments;
	return Array.from({ length: count }, (_, piece) => piece).filter((piece) => radii[2 * piece + 1] >= least);
}

/**
 * Returns the column `between`: how far each vertex is from the nearest vein that puckers the blade, 0 at the vein to
 * BETWEEN_STEPS at FULL_HEIGHT_DISTANCE or further. The view lifts the blade by it.
 */
function distancesFromVeins(leaf: Leaf, points: Float32Array): Uint8Array {
	const veins = indicesOfWideVeins(leaf, LEAST_PUCKERING_WIDTH);
	return Uint8Array.from({ length: points.length / 2 }, (_, vertex) => {
		const [x, y] = points.subarray(2 * vertex, 2 * vertex + 2);
		const nearest = veins.reduce(
			(least, piece) => Math.min(least, distanceFromSegment(leaf.chart, piece, x, y)),
			FULL_HEIGHT_DISTANCE,
		);
		return Math.round((BETWEEN_STEPS * nearest) / FULL_HEIGHT_DISTANCE);
	});
}

/**
 * Returns the distance of a point from a segment of a vein: the nearest point is at parameter t, 0 … 1, of the segment.
 * @param chart 4 numbers for each segment: start x y, end x y
 * @param piece index of the segment
 */
function distanceFromSegment(chart: Float32Array, piece: number, x: number, y: number): number {
	const [x1, y1, x2, y2] = chart.subarray(4 * piece, 4 * piece + 4);
	const [dx, dy] = [x2 - x1, y2 - y1];
	const squaredLength = dx * dx + dy * dy;
	const t = squaredLength > 0 ? Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / squaredLength)) : 0;
	return Math.hypot(x - x1 - t * dx, y - y1 - t * dy);
}

/** Returns the leaf without the veins that would be noise in a small picture. */
function withoutThinVeins(leaf: Leaf): Leaf {
	const visible = indicesOfWideVeins(leaf, LEAST_PICTURE_WIDTH);
	const selected = (values: Float32Array, width: number) =>
		Float32Array.from(visible.flatMap((piece) => [...values.subarray(width * piece, width * (piece + 1))]));
	const segments = { ...leaf.segments, count: visible.length, radii: selected(leaf.segments.radii, 2) };
	return { ...leaf, chart: selected(leaf.chart, 4), energy: selected(leaf.energy, 1), segments };
}

/**
 * Draws the veins in side × side shades of grey; rows of the picture run from the top, rows of the raster from the
 * bottom.
 */
function veinPicture(leaf: Leaf, millimetres: number, side: number): Uint8Array {
	const { cover } = veinRaster(leaf, millimetres, side);
	const pixels = new Uint8Array(side * side);
	for (let at = 0; at < pixels.length; at++) {
		// The square root makes thin veins, which cover little of a pixel, visible.
		const shade = Math.round((SHADES - 1) * Math.sqrt(cover[at]));
		pixels[(side - 1 - Math.floor(at / side)) * side + (at % side)] = (shade * 255) / (SHADES - 1);
	}
	return pixels;
}
