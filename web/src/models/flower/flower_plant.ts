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

export interface FlowerPlant extends Plant {
	volumes: Volumes;
	/** Of each mesh, 2 × meshes: where an organ begins and where it ends, 0xrrggbb as sRGB. */
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
		colours: columns.has("materials.colours") ? columns.words("materials.colours") : new Uint32Array(),
	};
}
