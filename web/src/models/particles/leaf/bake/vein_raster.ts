/** The flat leaf in cells: what of each is vein, how high veins stand there, how far the margin is. */
import type { Leaf } from "../grown";
import { chartSquare } from "../parts/vein_map";

export interface VeinRaster {
	/** Cells to a side of the square that texture coordinates span; rows from the bottom. */
	side: number;
	/** Millimetres to a cell. */
	cell: number;
	/** Share of the cell that is vein, 0 … 1. */
	cover: Float32Array;
	/** How high a vein stands there, were it half a round one: millimetres. */
	height: Float32Array;
	/** How far the margin is, in lengths of the leaf; 0 outside. */
	edge: Float32Array;
}

/** @param millimetres of a length of the leaf */
export function veinRaster(leaf: Leaf, millimetres: number, side: number): VeinRaster {
	const { left, bottom, size } = chartSquare(leaf.margin);
	const cell = (size * millimetres) / side;
	const cover = new Float32Array(side * side);
	const height = new Float32Array(side * side);
	const place = (value: number, low: number) => ((value - low) / size) * side;
	const { chart, segments } = leaf;
	for (let piece = 0; piece < segments.count; piece++) {
		const [x1, y1] = [place(chart[4 * piece], left), place(chart[4 * piece + 1], bottom)];
		const [x2, y2] = [place(chart[4 * piece + 2], left), place(chart[4 * piece + 3], bottom)];
		const radius = (segments.radii[2 * piece + 1] * 1000) / cell;
		const reach = Math.max(radius, 0.5) + 0.5;
		const [dx, dy] = [x2 - x1, y2 - y1];
		const squared = dx * dx + dy * dy;
		const within = (value: number) => Math.min(side - 1, Math.max(0, Math.floor(value)));
		for (let row = within(Math.min(y1, y2) - reach); row <= within(Math.max(y1, y2) + reach); row++) {
			for (let column = within(Math.min(x1, x2) - reach); column <= within(Math.max(x1, x2) + reach); column++) {
				const [px, py] = [column + 0.5 - x1, row + 0.5 - y1];
				const t = squared > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / squared)) : 0;
				const away = Math.hypot(px - t * dx, py - t * dy);
				if (away >= reach) continue;
				const at = row * side + column;
				// What is finer than a cell covers less of it.
				const share = Math.min(1, reach - away) * Math.min(1, 2 * radius);
				if (share > cover[at]) cover[at] = share;
				const high = cell * Math.sqrt(Math.max(0, radius * radius - away * away));
				if (high > height[at]) height[at] = high;
			}
		}
	}
	return { side, cell, cover, height, edge: edgeOf(leaf.margin, side).map((cells) => (cells * size) / side) };
}

/** How many cells the margin is away inside of it; 0 outside. */
function edgeOf(margin: Float32Array, side: number): Float32Array {
	const away = filled(margin, side);
	const relax = (at: number, other: number, cost: number) => {
		if (away[other] + cost < away[at]) away[at] = away[other] + cost;
	};
	for (let at = side + 1; at < away.length; at++) {
		relax(at, at - 1, 1);
		relax(at, at - side, 1);
		relax(at, at - side - 1, Math.SQRT2);
		relax(at, at - side + 1, Math.SQRT2);
	}
	for (let at = away.length - side - 2; at >= 0; at--) {
		relax(at, at + 1, 1);
		relax(at, at + side, 1);
		relax(at, at + side + 1, Math.SQRT2);
		relax(at, at + side - 1, Math.SQRT2);
	}
	return away;
}

/** 0 outside of the margin, more than any distance inside; row by row between the crossings. */
function filled(margin: Float32Array, side: number): Float32Array {
	const { left, bottom, size } = chartSquare(margin);
	const inside = new Float32Array(side * side);
	const count = margin.length / 2;
	for (let row = 0; row < side; row++) {
		const y = bottom + ((row + 0.5) / side) * size;
		const crossings: number[] = [];
		for (let i = 0; i < count; i++) {
			const j = (i + 1) % count;
			const [y1, y2] = [margin[2 * i + 1], margin[2 * j + 1]];
			if (y1 > y === y2 > y) continue;
			const x = margin[2 * i] + ((y - y1) / (y2 - y1)) * (margin[2 * j] - margin[2 * i]);
			crossings.push(((x - left) / size) * side - 0.5);
		}
		crossings.sort((a, b) => a - b);
		for (let k = 0; k + 1 < crossings.length; k += 2) {
			const to = Math.min(side - 1, Math.floor(crossings[k + 1]));
			for (let column = Math.max(0, Math.ceil(crossings[k])); column <= to; column++) {
				inside[row * side + column] = 2 * side;
			}
		}
	}
	return inside;
}
