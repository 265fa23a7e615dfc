/** Rasterizes the veins of the flat leaf: coverage and height by cell. */
import type { Leaf } from "../grown";
import { inCells } from "./chart";

/** Width of the pale sheath on either side of a vein, millimetres; it shows where veins are too thin. */
export const SHEATH = 0.012;
/** Opacity of the vein with the least energy; it increases to 1 with the logarithm of the energy. */
export const FAINTEST = 0.4;
/** Radius of a ridge's foot, in radii of its vein: the ridge rises smoothly out of the blade. */
const FOOT = 1.6;
/** Least radius of a ridge's foot, in cells: a ridge that is widened is lowered in proportion. */
const LEAST_FOOT = 1.5;

export interface VeinRaster {
	/** Cells along a side of the square of texture coordinates; rows from the bottom. */
	side: number;
	/** Millimetres per cell. */
	cell: number;
	/** Share of the cell that vein or sheath covers, 0 … 1. */
	cover: Float32Array;
	/** Opacity of the veins' colour by cell: it increases with the energy (Rodkaew et al. 2003, figure 4). */
	ink: Float32Array;
	/** Height of the relief, millimetres: on a vein's axis half its width. Empty where not requested. */
	height: Float32Array;
}

/**
 * Draws all veins into a raster of side × side cells.
 * @param millimetres length of the leaf
 * @param raised whether heights are computed
 */
export function veinRaster(
	{
		chart: ends,
		square,
		energy,
		segments,
	}: Pick<Leaf, "chart" | "square" | "energy"> & { segments: Pick<Leaf["segments"], "count" | "radii"> },
	millimetres: number,
	side: number,
	raised = true,
): VeinRaster {
	const cell = (square.size * millimetres) / side;
	const raster = {
		side,
		cell,
		cover: new Float32Array(side * side),
		ink: new Float32Array(side * side),
		height: new Float32Array(raised ? side * side : 0),
	};
	const places = inCells(ends, square, side);
	const range = logarithmicRange(energy);
	for (let piece = 0; piece < segments.count; piece++) {
		const radius = (segments.radii[2 * piece + 1] * 1000) / cell;
		drawSegment(raster, places, 4 * piece, radius, opacityOf(energy[piece], range));
	}
	return raster;
}

/**
 * Returns the logarithms of the least and the largest positive energy; trails that no particle has passed have none.
 */
function logarithmicRange(energy: Float32Array): readonly [least: number, most: number] {
	let [least, most] = [Number.POSITIVE_INFINITY, 0];
	for (const each of energy) if (each > 0) [least, most] = [Math.min(least, each), Math.max(most, each)];
	return [Math.log(least), Math.log(most)];
}

/** Returns the opacity of a vein, FAINTEST … 1, from its energy and the range of all energies' logarithms. */
function opacityOf(energy: number, [least, most]: readonly [number, number]): number {
	if (!(energy > 0)) return FAINTEST;
	return most > least ? FAINTEST + ((1 - FAINTEST) * (Math.log(energy) - least)) / (most - least) : 1;
}

/**
 * Draws one segment of a vein into coverage, ink and height.
 * @param places ends of all segments, in cells: x y x y each
 * @param from index of the segment's first number in `places`
 * @param radius in cells
 * @param strong opacity of the vein
 */
function drawSegment(
	{ side, cell, cover, ink, height }: VeinRaster,
	places: Float32Array,
	from: number,
	radius: number,
	strong: number,
): void {
	const x1 = places[from];
	const y1 = places[from + 1];
	const dx = places[from + 2] - x1;
	const dy = places[from + 3] - y1;
	// Half of the drawn width: the vein with its pale sheath, at least half a cell; then the height's profile.
	const pale = radius + SHEATH / cell;
	const covering = Math.max(pale, 0.5) + 0.5;
	const thin = Math.min(1, 2 * pale);
	const foot = Math.max(FOOT * radius, LEAST_FOOT);
	const top = (cell * radius * FOOT * radius) / foot;
	const reach = Math.max(covering, foot);
	const squared = dx * dx + dy * dy;
	const left = cellOf(x1 + Math.min(0, dx) - reach, side);
	const right = cellOf(x1 + Math.max(0, dx) + reach, side);
	const upTo = cellOf(y1 + Math.max(0, dy) + reach, side);
	for (let row = cellOf(y1 + Math.min(0, dy) - reach, side); row <= upTo; row++) {
		for (let column = left; column <= right; column++) {
			// The distance from the middle of the cell to the segment, squared.
			const px = column + 0.5 - x1;
			const py = row + 0.5 - y1;
			const t = squared > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / squared)) : 0;
			const ox = px - t * dx;
			const oy = py - t * dy;
			const away = ox * ox + oy * oy;
			if (away >= reach * reach) continue;
			const at = row * side + column;
			// Veins thinner than a cell cover less of it.
			const share = Math.min(1, covering - Math.sqrt(away)) * thin;
			if (share > cover[at]) cover[at] = share;
			if (share * strong > ink[at]) ink[at] = share * strong;
			if (height.length === 0) continue;
			// A smooth ridge, which ends flat at `foot`.
			const slope = Math.max(0, 1 - away / (foot * foot));
			const high = top * slope * slope;
			if (high > height[at]) height[at] = high;
		}
	}
}

/** Returns the row or column in which a coordinate (in cells) lies, limited to the raster. */
function cellOf(value: number, side: number): number {
	return Math.min(side - 1, Math.max(0, Math.floor(value)));
}
