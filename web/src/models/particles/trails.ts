/** The trails of particles, common to leaf, tree and root (wasm-core/src/models/particles/trail_plant.hpp). */
import type { Answer } from "../../core/core";
import type { Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";

/**
 * A plant whose segments are trails. `parent` is −1 at a target and at a moving particle; `start` is nearer to the
 * target.
 */
export interface TrailPlant extends Plant {
	/** Energy that flows through each segment. */
	energy: Float32Array;
	/** Step at which a particle left each segment. */
	born: Uint32Array;
	/** Positions of the targets, 3 × targets, metres. */
	targets: Float32Array;
	/** Energy that has arrived at each target. */
	arrived: Float32Array;
}

/**
 * Reads a plant with each segment's energy and step of origin, and the targets with the energy that arrived at them.
 */
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
