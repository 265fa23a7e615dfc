import type { TrailPlant } from "../particles/trails";
import type { FlatVeins } from "./outline/outline_canvas";

/** What else is known of a face of the blade, by vertex. */
export interface BladeFace {
	/** How far the margin is, in lengths of the leaf, about. */
	edge: Float32Array;
}

/** The square that texture coordinates span, in lengths of the leaf. */
export interface Chart {
	left: number;
	bottom: number;
	size: number;
}

/** A grown leaf: its veins are trails, first as they lie flat, in lengths of the leaf. */
export interface Leaf extends TrailPlant {
	/** 4 × segments: start x y, end x y in the flat chart, in lengths of the leaf. */
	chart: Float32Array;
	/** 2 × points: the margin with its teeth, counter-clockwise from the base, in lengths of the leaf. */
	margin: Float32Array;
	/** The square about the margin. */
	square: Chart;
	/** What is known at the vertices of the blade's faces, by the names of their meshes: none without meshes. */
	faces: Record<string, BladeFace>;
}

/** The veins as the flat views draw them. */
export function flatVeins({ chart, margin, segments }: Leaf, millimetres: number): FlatVeins {
	const widths = Float32Array.from({ length: segments.count }, (_, i) => {
		const [start, end] = segments.radii.subarray(2 * i, 2 * i + 2);
		return ((start + end) * 1000) / millimetres;
	});
	return { ends: chart, widths, margin };
}
