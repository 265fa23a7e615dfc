/** What leaf, tree and root have in common: the trails of particles (wasm-core/src/models/particles/trail_plant.hpp). */
import type { Answer } from "../../core/core";
import type { Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";

/** A plant whose segments are trails: `parent` −1 at a target, or where a particle is on its way; `start` nearer the target. */
export interface TrailPlant extends Plant {
	/** By segment: the energy that passes. */
	energy: Float32Array;
	/** By segment: the step that left it. */
	born: Uint32Array;
	/** 3 × targets, metres. */
	targets: Float32Array;
	/** By target: the energy that has arrived. */
	arrived: Float32Array;
}

export function readTrailPlant(answer: Answer): TrailPlant {
	const { columns } = answer;
	return {
		...readPlant(answer),
		energy: columns.floats("segments.energy"),
		born: columns.uint32("segments.born"),
		targets: columns.floats("targets.places"),
		arrived: columns.floats("targets.energy"),
	};
}
