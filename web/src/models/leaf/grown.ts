import type { TrailPlant } from "../particles/trails";
import type { FlatVeins } from "./outline/outline_canvas";

/** Additional columns of a face of the blade, by vertex. */
export interface BladeFace {
	/** Approximate distance from the margin, in leaf lengths. */
	edge: Float32Array;
}

/** The square of the texture coordinates, in leaf lengths. */
export interface Chart {
	left: number;
	bottom: number;
	size: number;
}

/** A grown leaf: its veins are trails. The flat chart is in leaf lengths. */
export interface Leaf extends TrailPlant {
	/** 4 × segments: start x y, end x y in the flat chart, in leaf lengths. */
	chart: Float32Array;
	/** 2 × points: the margin with its teeth, counter-clockwise from the base, in leaf lengths. */
	margin: Float32Array;
	/** The square around the margin. */
	square: Chart;
	/** Columns of the blade's faces, by the names of their meshes; empty without meshes. */
	faces: Record<string, BladeFace>;
}

/**
 * Returns the veins and the margin for the flat views, with widths in leaf lengths.
 * @param millimetres length of the leaf
 */
export function flatVeins({ chart, margin, segments }: Leaf, millimetres: number): FlatVeins {
	const widths = Float32Array.from({ length: segments.count }, (_, i) => {
		const [start, end] = segments.radii.subarray(2 * i, 2 * i + 2);
		return ((start + end) * 1000) / millimetres;
	});
	return { ends: chart, widths, margin };
}
