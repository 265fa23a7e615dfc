/**
 * Inputs of a blade's colour on a coarse grid over its chart: distance from the margin, supply by nearby veins, and
 * noise. They do not depend on the look, so a change of colours reuses them.
 */
import { noise } from "../../../plant/noise";
import type { Chart, Leaf } from "../grown";
import { distanceTransform, inCells, insideOf } from "./chart";

/** Noise cells per metre: broad patches, mottling. */
const BROAD = 60;
const MOTTLE = 420;
/** Least relative width of veins that matter: those visible from afar. */
const LEAST_WIDTH = 0.1;
/**
 * Distance over which the widest vein supplies the blade, in sides of the square, and the power of the relative width
 * for other veins.
 */
const REACH = 0.085;
const REACH_POWER = 0.6;
/** Power of the relative width for the supply on the vein's axis. */
const STRENGTH_POWER = 0.3;
/** Width of the paler halo, equal along all veins, in sides of the square. */
const HALO_REACH = 0.018;

/** Fields by cell, rows from the bottom, that depend on margin and noise but not on veins. */
interface Ground {
	/** Cells along a side of the square. */
	side: number;
	/** 1 inside the margin and in the cells around it, else 0. */
	near: Uint8Array;
	/** Distance from the margin, in leaf lengths; 0 outside. */
	edge: Float32Array;
	/** Noise of broad patches and of mottling, each −0.5 … 0.5. */
	broad: Float32Array;
	mottle: Float32Array;
}

/** All fields of a blade. */
export interface BladeFields extends Ground {
	/** Supply by veins: 1 on the widest … 0 far from all; wider veins reach farther. */
	fed: Float32Array;
	/** Halo: 1 on a vein visible from afar … 0 slightly beside it. */
	halo: Float32Array;
}

/**
 * Returns the fields of a blade on a grid of side × side cells.
 * @param millimetres length of the leaf
 * @param seed changes the noise
 */
export function bladeFields(
	leaf: Pick<Leaf, "chart" | "margin" | "square"> & { segments: Pick<Leaf["segments"], "radii"> },
	millimetres: number,
	seed: number,
	side: number,
): BladeFields {
	return { ...groundOf(leaf, millimetres, seed, side), ...feedingOf(leaf, leaf.square, side) };
}

/** The last result: while particles move, all frames have the same. */
let lastGround: { margin: Float32Array; rest: string; ground: Ground } | undefined;

type Flat = Pick<Leaf, "margin" | "square">;

/** Returns the fields that do not depend on veins; reuses the last ones if all inputs are the same. */
function groundOf({ margin, square }: Flat, millimetres: number, seed: number, side: number): Ground {
	const otherInputs = JSON.stringify([square, millimetres, seed, side]);
	const isSame = lastGround?.rest === otherInputs && lastGround.margin.length === margin.length;
	if (lastGround && isSame && lastGround.margin.every((value, at) => value === margin[at])) return lastGround.ground;
	lastGround = { margin, rest: otherInputs, ground: computeGround({ margin, square }, millimetres, seed, side) };
	return lastGround.ground;
}

/**
 * Computes the fields that do not depend on veins, on a grid of side × side cells. Noise is in metres, so that its
 * grain does not depend on the size of the leaf.
 */
function computeGround({ margin, square }: Flat, millimetres: number, seed: number, side: number): Ground {
	const edge = edgeOf(margin, square, side);
	const near = markNearLeaf(edge, side);
	const broad = new Float32Array(side * side);
	const mottle = new Float32Array(side * side);
	const metres = (square.size * millimetres) / 1000 / side;
	const seedOffset = (seed % 4096) * 7.31;
	for (let at = 0; at < side * side; at++) {
		if (!near[at]) continue;
		const [x, y] = [(at % side) * metres, Math.floor(at / side) * metres];
		broad[at] = noise(BROAD * x, BROAD * y, seedOffset) - 0.5;
		mottle[at] = noise(MOTTLE * x, MOTTLE * y, seedOffset) - 0.5;
	}
	return { side, near, edge, broad, mottle };
}

/** Returns the distance of each cell from the margin, in leaf lengths; 0 outside the leaf. */
function edgeOf(margin: Float32Array, square: Chart, side: number): Float32Array {
	const distances = Float32Array.from(insideOf(inCells(margin, square, side), side), (inside) =>
		inside ? 2 * side : 0,
	);
	distanceTransform(distances, side);
	return distances.map((cells) => (Math.max(0, cells - 0.5) * square.size) / side);
}

/**
 * Marks with 1 the cells of the leaf and those up to two cells beside it, from which textures interpolate at the
 * margin.
 */
function markNearLeaf(edge: Float32Array, side: number): Uint8Array {
	const near = new Uint8Array(side * side);
	for (let row = 0; row < side; row++) {
		for (let column = 0; column < side; column++) {
			if (edge[row * side + column] <= 0) continue;
			for (let y = Math.max(0, row - 2); y <= Math.min(side - 1, row + 2); y++) {
				near.fill(1, y * side + Math.max(0, column - 2), y * side + Math.min(side, column + 3));
			}
		}
	}
	return near;
}

/**
 * Computes the supply of each cell by the veins, and the paler halo along them.
 * @param side cells along a side of the square
 */
function feedingOf(
	{ chart: ends, segments: { radii } }: Pick<Leaf, "chart"> & { segments: Pick<Leaf["segments"], "radii"> },
	square: Chart,
	side: number,
): Pick<BladeFields, "fed" | "halo"> {
	const widest = radii.reduce((most, radius) => Math.max(most, radius), 1e-9);
	const distances = new Float32Array(side * side).fill(2 * side);
	/** The vein that supplies each cell: position of its axis and relative width; 0 where there is none yet. */
	const [atX, atY, width] = [0, 0, 0].map(() => new Float32Array(side * side));
	const cells = inCells(ends, square, side);
	for (let segment = 0; 4 * segment < ends.length; segment++) {
		const relativeWidth = radii[2 * segment + 1] / widest;
		if (relativeWidth < LEAST_WIDTH) continue;
		const [x1, y1, x2, y2] = cells.subarray(4 * segment, 4 * segment + 4);
		// Points of the segment at most half a cell apart; the widest vein of a cell counts.
		const steps = Math.ceil(Math.hypot(x2 - x1, y2 - y1) * 2) + 1;
		for (let step = 0; step <= steps; step++) {
			const [x, y] = [x1 + ((x2 - x1) * step) / steps, y1 + ((y2 - y1) * step) / steps];
			const at = cellOf(y, side) * side + cellOf(x, side);
			distances[at] = 0;
			if (relativeWidth <= width[at]) continue;
			[atX[at], atY[at], width[at]] = [x, y, relativeWidth];
		}
	}
	// Distances to the nearest vein, in cells.
	distanceTransform(distances, side);
	const reach = Float32Array.from(width, (relativeWidth) => REACH * side * relativeWidth ** REACH_POWER);
	const fed = spreadSupply(side, atX, atY, width, reach);
	const halo = distances.map((cells) => Math.max(0, 1 - cells / (HALO_REACH * side)) ** 2);
	return { fed, halo };
}

/**
 * Spreads the supply of the veins over all cells, in two passes over the grid: each cell takes the vein that supplies
 * it best from its neighbours. Returns the supply of each cell; overwrites the four arrays.
 * @param side cells along a side
 * @param atX position of each cell's vein, cells; `atY` likewise
 * @param width relative width of each cell's vein; 0 where it has none yet
 * @param reach distance over which that vein supplies the blade, cells
 */
function spreadSupply(
	side: number,
	atX: Float32Array,
	atY: Float32Array,
	width: Float32Array,
	reach: Float32Array,
): Float32Array {
	/** Logarithm of each cell's supply. */
	const logSupply = Float32Array.from(width, (share, at) => {
		if (share === 0) return Number.NEGATIVE_INFINITY;
		const distance = Math.hypot(atX[at] - (at % side) - 0.5, atY[at] - Math.floor(at / side) - 0.5) / reach[at];
		return STRENGTH_POWER * Math.log(share) - distance ** 1.5;
	});
	/** Gives the vein that supplies the cell `from` to the cell `at`, if it supplies it better than its own. */
	const takeFrom = (at: number, from: number) => {
		if (width[from] === 0) return;
		const dx = atX[from] - (at % side) - 0.5;
		const dy = atY[from] - Math.floor(at / side) - 0.5;
		const distance = Math.sqrt(dx * dx + dy * dy) / reach[from];
		const candidate = STRENGTH_POWER * Math.log(width[from]) - distance * Math.sqrt(distance);
		if (candidate <= logSupply[at]) return;
		logSupply[at] = candidate;
		atX[at] = atX[from];
		atY[at] = atY[from];
		width[at] = width[from];
		reach[at] = reach[from];
	};
	const last = side * side - 1;
	for (const sign of [-1, 1]) {
		for (let k = 0; k <= last; k++) {
			const at = sign < 0 ? k : last - k;
			const column = at % side;
			const hasBeside = column + sign >= 0 && column + sign < side;
			const hasRow = at + sign * side >= 0 && at + sign * side <= last;
			if (hasBeside) takeFrom(at, at + sign);
			if (!hasRow) continue;
			takeFrom(at, at + sign * side);
			if (hasBeside) takeFrom(at, at + sign * (side + 1));
			if (column - sign >= 0 && column - sign < side) takeFrom(at, at + sign * (side - 1));
		}
	}
	return logSupply.map((value) => Math.exp(value));
}

/** Returns the row or column in which a coordinate (in cells) lies, limited to the grid. */
function cellOf(place: number, side: number): number {
	return Math.min(side - 1, Math.max(0, Math.floor(place)));
}
