/** The light in a crown's cells, as the core works it out (Rodkaew et al. 2003, section 4.2, figure 8). */
import type { Answer } from "../../../core/core";

export interface LightGrid {
	/** Share of all light in each cell, 255 for all of it; x fastest, then y. */
	readonly cells: Uint8Array;
	/** How many cells there are along x, y and z. */
	readonly counts: readonly [x: number, y: number, z: number];
	/** The lowest corner, metres. */
	readonly low: readonly [x: number, y: number, z: number];
	/** Edge of a cell, metres. */
	readonly edge: number;
}

/** Undefined where the request asked for none. */
export function readLight({ columns }: Answer): LightGrid | undefined {
	if (!columns.has("light.cells")) return undefined;
	const [x, y, z] = columns.uint32("light.counts");
	const [lowX, lowY, lowZ, edge] = columns.floats("light.box");
	return { cells: columns.uint8("light.cells"), counts: [x, y, z], low: [lowX, lowY, lowZ], edge };
}

/** The points that show a grid: the middles of its cells, metres, and of each its red, green, blue and opacity, 0 … 1. */
export interface LightPoints {
	readonly positions: Float32Array;
	readonly colours: Float32Array;
}

/** What a cell without light looks like, and one with all of it. */
const DARK = [0.1, 0.16, 0.36];
const BRIGHT = [1, 0.86, 0.35];
/** How opaque each of them is: what is bright is seen through, so that the shadow within is. */
const DARK_OPACITY = 0.16;
const BRIGHT_OPACITY = 0.015;

export function lightPoints({ cells, counts: [x, y], low, edge }: LightGrid): LightPoints {
	const positions = new Float32Array(3 * cells.length);
	const colours = new Float32Array(4 * cells.length);
	cells.forEach((cell, i) => {
		const at = [i % x, Math.floor(i / x) % y, Math.floor(i / (x * y))];
		const share = cell / 255;
		for (let k = 0; k < 3; k++) {
			positions[3 * i + k] = low[k] + (at[k] + 0.5) * edge;
			colours[4 * i + k] = DARK[k] + share * (BRIGHT[k] - DARK[k]);
		}
		colours[4 * i + 3] = DARK_OPACITY + share * (BRIGHT_OPACITY - DARK_OPACITY);
	});
	return { positions, colours };
}
