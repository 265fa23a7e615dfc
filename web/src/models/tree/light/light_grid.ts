/** The light in the cells of a crown, as computed by the core (Rodkaew et al. 2003, section 4.2, figure 8). */
import type { Answer } from "../../../core/core";

export interface LightGrid {
	/** Share of the full light in each cell, 255 for all of it; x fastest, then y. */
	readonly cells: Uint8Array;
	/** Number of cells along x, y and z. */
	readonly counts: readonly [x: number, y: number, z: number];
	/** The corner with the least coordinates, metres. */
	readonly low: readonly [x: number, y: number, z: number];
	/** Side length of a cell, metres. */
	readonly edge: number;
}

/** Reads the light; undefined where it was not requested. */
export function readLight({ columns }: Answer): LightGrid | undefined {
	if (!columns.has("light.cells")) return undefined;
	const [x, y, z] = columns.uint32("light.counts");
	const [lowX, lowY, lowZ, edge] = columns.floats("light.box");
	return { cells: columns.uint8("light.cells"), counts: [x, y, z], low: [lowX, lowY, lowZ], edge };
}

/** Points that display a grid: centres of the cells, metres, and red, green, blue and opacity of each, 0 … 1. */
export interface LightPoints {
	readonly positions: Float32Array;
	readonly colours: Float32Array;
}

/** Colours of a cell without light and of a fully lit cell. */
const DARK = [0.1, 0.16, 0.36];
const BRIGHT = [1, 0.86, 0.35];
/** Opacities of the two: bright cells are transparent, so that the shade inside is visible. */
const DARK_OPACITY = 0.16;
const BRIGHT_OPACITY = 0.015;

/**
 * Returns a point in the middle of each cell, brighter and more transparent with more light. Colours have four values: red,
 * green, blue, opacity.
 */
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
