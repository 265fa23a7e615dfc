/** Applies changes of controls to a document. Pure functions. */

import { withLook, withParameters, withSeed } from "../specimen/edit";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import type { Change } from "./editor_context";

/** Returns the specimen with a change applied. */
export function apply<S extends Specimen>(
	schema: ModelSchema<S>,
	specimen: S,
	{ parameters = {}, look = {}, details = {}, seed }: Change,
): S {
	const next = { ...withLook(schema, withParameters(schema, specimen, parameters), look), ...details };
	return seed === undefined ? next : withSeed(next, seed);
}

/** Returns another random seed, so that every press shows another plant. */
export function otherSeed(seed: number, random: () => number = Math.random): number {
	const drawn = Math.floor(random() * SEEDS_DRAWN) + 1;
	return drawn === seed ? (drawn % SEEDS_DRAWN) + 1 : drawn;
}

/** Largest random seed: short enough to be read aloud. Every seed up to 4294967295 can be typed. */
const SEEDS_DRAWN = 99_999;
