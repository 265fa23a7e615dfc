/** How far from a vein the places of a blade are: a map over the square of the chart that its texture coordinates span. */
import type { Leaf } from "../grown";

/** Cells to a side of the square. */
const SIDE = 192;
/** Only what the eye sees from afar: veins at least this wide, against the widest. */
const LEAST_WIDTH = 0.16;
/** Farther than this, in sides of the square, is as far as anywhere. */
const FARTHEST = 0.045;

/** By cell, rows from the bottom: 0 on a vein … 1 as far as anywhere. */
export type VeinMap = Float32Array;

export function veinMap({ chart, margin, segments: { radii } }: Pick<Leaf, "chart" | "margin" | "segments">): VeinMap {
	const { left, bottom, size } = chartSquare(margin);
	const widest = radii.reduce((most, radius) => Math.max(most, radius), 0);
	const away = new Float32Array(SIDE * SIDE).fill(SIDE);
	for (let piece = 0; 4 * piece < chart.length; piece++) {
		if (radii[2 * piece + 1] < LEAST_WIDTH * widest) continue;
		const [x1, y1, x2, y2] = chart.subarray(4 * piece, 4 * piece + 4);
		const steps = Math.ceil((Math.hypot(x2 - x1, y2 - y1) / size) * SIDE * 2) + 1;
		for (let step = 0; step <= steps; step++) {
			const column = cellOf((x1 + ((x2 - x1) * step) / steps - left) / size);
			const row = cellOf((y1 + ((y2 - y1) * step) / steps - bottom) / size);
			away[row * SIDE + column] = 0;
		}
	}
	spread(away);
	return away.map((cells) => Math.min(1, cells / (FARTHEST * SIDE)));
}

/** The map at a texture coordinate. */
export function awayAt(map: VeinMap, u: number, v: number): number {
	const [x, y] = [u, v].map((value) => Math.min(SIDE - 1.001, Math.max(0, value * SIDE - 0.5)));
	const [column, row] = [Math.floor(x), Math.floor(y)];
	const at = row * SIDE + column;
	const low = map[at] + (map[at + 1] - map[at]) * (x - column);
	const high = map[at + SIDE] + (map[at + SIDE + 1] - map[at + SIDE]) * (x - column);
	return low + (high - low) * (y - row);
}

/** The square about the margin's middle that holds it, in lengths of the leaf. */
export function chartSquare(margin: Float32Array): { left: number; bottom: number; size: number } {
	let [left, right, bottom, top] = [0, 0, 0, 0];
	for (let at = 0; at < margin.length; at += 2) {
		[left, right] = [Math.min(left, margin[at]), Math.max(right, margin[at])];
		[bottom, top] = [Math.min(bottom, margin[at + 1]), Math.max(top, margin[at + 1])];
	}
	const size = Math.max(right - left, top - bottom, 1e-6);
	return { left: (left + right - size) / 2, bottom: (bottom + top - size) / 2, size };
}

function cellOf(share: number): number {
	return Math.min(SIDE - 1, Math.max(0, Math.floor(share * SIDE)));
}

/** Distances to the nearest zero, in cells, by two chamfered passes (Borgefors 1986). */
function spread(away: Float32Array): void {
	const relax = (at: number, other: number, cost: number) => {
		if (away[other] + cost < away[at]) away[at] = away[other] + cost;
	};
	const last = SIDE * SIDE - 1;
	for (let k = 0; k <= 2 * last + 1; k++) {
		const forward = k <= last;
		const at = forward ? k : 2 * last + 1 - k;
		const sign = forward ? -1 : 1;
		const column = at % SIDE;
		const inner = forward ? column > 0 : column < SIDE - 1;
		const outer = forward ? column < SIDE - 1 : column > 0;
		const row = forward ? at >= SIDE : at + SIDE <= last;
		if (inner) relax(at, at + sign, 1);
		if (row) relax(at, at + sign * SIDE, 1);
		if (row && inner) relax(at, at + sign * (SIDE + 1), Math.SQRT2);
		if (row && outer) relax(at, at + sign * (SIDE - 1), Math.SQRT2);
	}
}
