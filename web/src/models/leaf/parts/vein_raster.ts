/** The veins of the flat leaf in cells: what of each is vein, and how high it stands there. */
import type { Leaf } from "../grown";
import { inCells } from "./chart";

/** Millimetres on either side of a vein that are as pale as it: the sheath about it, which shows where veins themselves are too fine. */
export const SHEATH = 0.012;
/** How much of its colour the vein has that the least energy passes; the others have more, as the logarithm of theirs goes. */
export const FAINTEST = 0.4;
/** A ridge ends this many radii of its vein from the axis: it rises smoothly out of the blade. */
const FOOT = 1.6;
/** The least width of its slope, in cells: what is finer is lower by as much as it is wider. */
const LEAST_FOOT = 1.5;

export interface VeinRaster {
	/** Cells to a side of the square that texture coordinates span; rows from the bottom. */
	side: number;
	/** Millimetres to a cell. */
	cell: number;
	/** Share of the cell that is vein or its sheath, 0 … 1. */
	cover: Float32Array;
	/** Of the same, what is to be seen in the veins' colour: the more energy passes, the more of it (Rodkaew et al. 2003, figure 4). */
	ink: Float32Array;
	/** How high a vein stands there, as high on its axis as half its width: millimetres; nothing where it was not asked for. */
	height: Float32Array;
}

/**
 * @param millimetres of a length of the leaf
 * @param raised whether heights are wanted
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
	const range = rangeOf(energy);
	for (let piece = 0; piece < segments.count; piece++) {
		const radius = (segments.radii[2 * piece + 1] * 1000) / cell;
		draw(raster, places, 4 * piece, radius, strength(energy[piece], range));
	}
	return raster;
}

/** Logarithms of the least and the most energy; ways that no particle has come yet have none. */
function rangeOf(energy: Float32Array): readonly [least: number, most: number] {
	let [least, most] = [Number.POSITIVE_INFINITY, 0];
	for (const each of energy) if (each > 0) [least, most] = [Math.min(least, each), Math.max(most, each)];
	return [Math.log(least), Math.log(most)];
}

function strength(energy: number, [least, most]: readonly [number, number]): number {
	if (!(energy > 0)) return FAINTEST;
	return most > least ? FAINTEST + ((1 - FAINTEST) * (Math.log(energy) - least)) / (most - least) : 1;
}

/** One straight piece of a vein, its radius in cells. */
function draw(
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
	const pale = radius + SHEATH / cell;
	const covering = Math.max(pale, 0.5) + 0.5;
	const thin = Math.min(1, 2 * pale);
	const foot = Math.max(FOOT * radius, LEAST_FOOT);
	const top = (cell * radius * FOOT * radius) / foot;
	const reach = Math.max(covering, foot);
	const squared = dx * dx + dy * dy;
	const left = within(x1 + Math.min(0, dx) - reach, side);
	const right = within(x1 + Math.max(0, dx) + reach, side);
	const upTo = within(y1 + Math.max(0, dy) + reach, side);
	for (let row = within(y1 + Math.min(0, dy) - reach, side); row <= upTo; row++) {
		for (let column = left; column <= right; column++) {
			const px = column + 0.5 - x1;
			const py = row + 0.5 - y1;
			const t = squared > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / squared)) : 0;
			const ox = px - t * dx;
			const oy = py - t * dy;
			const away = ox * ox + oy * oy;
			if (away >= reach * reach) continue;
			const at = row * side + column;
			// What is finer than a cell covers less of it.
			const share = Math.min(1, covering - Math.sqrt(away)) * thin;
			if (share > cover[at]) cover[at] = share;
			if (share * strong > ink[at]) ink[at] = share * strong;
			if (height.length === 0) continue;
			const slope = Math.max(0, 1 - away / (foot * foot));
			const high = top * slope * slope;
			if (high > height[at]) height[at] = high;
		}
	}
}

function within(value: number, side: number): number {
	return Math.min(side - 1, Math.max(0, Math.floor(value)));
}
