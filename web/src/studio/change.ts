/** The pure half of the store: what a control's change makes of the document. */

import { LOOK_KEYS } from "../models/bunch/parameters.generated";
import { withOpposites } from "../models/bunch/profile/drag";
import { SIDES } from "../models/bunch/profile/handles";
import { withLook, withParameters, withSeed } from "../specimen/edit";
import { specimenFromPreset } from "../specimen/from_preset";
import { sameSpecimen } from "../specimen/same";
import type { Specimen } from "../specimen/specimen";
import type { Change, Locks } from "./types";

/** The specimen with the change in it. Locked sides follow the one that moved, unless the change names both. */
export function apply(specimen: Specimen, change: Change, locks: Locks): Specimen {
	let next = withParameters(specimen, withOpposites(change.parameters ?? {}, locks));
	for (const key of LOOK_KEYS) {
		const value = change.look?.[key];
		if (value !== undefined) next = withLook(next, key, value);
	}
	return change.seed === undefined ? next : withSeed(next, change.seed);
}

/** The values that switching a lock on sets at once: left takes right's, back takes front's. */
export function lockSides({ parameters }: Specimen, lock: keyof Locks): Change {
	const side = lock === "leftRight" ? "p3" : "p5";
	const { opposite } = SIDES[side];
	return { parameters: { [`${opposite}w`]: parameters[`${side}w`], [`${opposite}r`]: parameters[`${side}r`] } };
}

/** Whether nothing of the paper's letter is bent. */
export function isAsPrinted({ parameters }: Specimen): boolean {
	return parameters.fit === 0 && parameters.vary === 0;
}

/** `fit` and `vary` to 0, or back to the values they had before (else the preset's). */
export function asPrinted(
	specimen: Specimen,
	on: boolean,
	before?: Pick<Specimen["parameters"], "fit" | "vary">,
): Change {
	if (on) return { parameters: { fit: 0, vary: 0 } };
	const { fit, vary } = before ?? specimenFromPreset(specimen.preset).parameters;
	return { parameters: { fit, vary } };
}

/** A seed that differs, so that every press shows another bunch. */
export function otherSeed(seed: number, random: () => number = Math.random): number {
	const drawn = Math.floor(random() * SEEDS_DRAWN) + 1;
	return drawn === seed ? (drawn % SEEDS_DRAWN) + 1 : drawn;
}

/** Short enough to be read aloud; every seed to 4294967295 may still be typed. */
const SEEDS_DRAWN = 99_999;

/** Whether two specimens grow the same bunch; colours do not count. */
export function growsAlike(a: Specimen, b: Specimen): boolean {
	return sameSpecimen({ ...a, look: b.look, preset: b.preset }, b);
}
