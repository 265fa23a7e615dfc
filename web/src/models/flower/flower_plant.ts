/** Columns of an answer → a flower (wasm-core/src/models/flower/model.hpp). */
import type { Answer } from "../../core/core";
import type { Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";

/** Volumes in the order in which they were made. */
export interface Volumes {
	/** What they are called, by `label`. */
	labels: readonly string[];
	label: Uint32Array;
	order: Uint32Array;
	/** That each grew from; 0xffffffff of the first. */
	parent: Uint32Array;
	/** 9 × volumes: N, T, atx, aty, atz, H, L, W, m. */
	values: Float32Array;
}

/** The map dart by dart (docs/generalized-maps.md). */
export interface Darts {
	/** α0 … α3, a dart for each dart. */
	alpha: readonly [Uint32Array, Uint32Array, Uint32Array, Uint32Array];
	/** The volume and the vertex that each is of. */
	volume: Uint32Array;
	vertex: Uint32Array;
	/** 3 × vertices, metres. */
	positions: Float32Array;
}

export interface FlowerPlant extends Plant {
	/** Absent of what has grown in passing. */
	darts?: Darts;
	volumes: Volumes;
	/** 4 × meshes: where an organ begins and where it ends, of its margin, of its veins; 0xrrggbb as sRGB. */
	colours: Uint32Array;
}

export function readFlowerPlant(answer: Answer): FlowerPlant {
	const { columns } = answer;
	return {
		...readPlant(answer),
		volumes: {
			labels: columns.text("labels").split(" "),
			label: columns.words("volumes.label"),
			order: columns.words("volumes.order"),
			parent: columns.words("volumes.parent"),
			values: columns.floats("volumes.values"),
		},
		...(columns.has("alpha0") ? { darts: readDarts(columns) } : {}),
		colours: columns.has("materials.colours") ? columns.words("materials.colours") : new Uint32Array(),
	};
}

function readDarts(columns: Answer["columns"]): Darts {
	return {
		alpha: [columns.words("alpha0"), columns.words("alpha1"), columns.words("alpha2"), columns.words("alpha3")],
		volume: columns.words("darts.volume"),
		vertex: columns.words("darts.vertex"),
		positions: columns.floats("vertices.position"),
	};
}
