/** Changes to a specimen that controls make: always in range, always on the steps that a link can hold. */

import type { LookKey, NumberKey } from "../models/bunch/parameters.generated";
import { MOST_THINNED } from "./limits";
import type { Look, Specimen } from "./specimen";
import { type CoreEntry, entryOf, nearestWithin } from "./table";

/** Sets parameters; smallest and largest radius push each other along, so that they never cross. */
export function withParameters(specimen: Specimen, changes: Partial<Record<NumberKey, number>>): Specimen {
	const parameters = { ...specimen.parameters };
	for (const [key, value] of Object.entries(changes) as [NumberKey, number][]) {
		if (Number.isNaN(value)) continue;
		parameters[key] = nearestWithin(entryOf(key) as CoreEntry, value);
	}
	if (parameters.rmin > parameters.rmax) {
		if (changes.rmin !== undefined) parameters.rmax = parameters.rmin;
		else parameters.rmin = parameters.rmax;
	}
	return { ...specimen, parameters };
}

/** Sets one value of the look: a colour of six hexadecimal digits, or a number. */
export function withLook<Key extends LookKey>(specimen: Specimen, key: Key, value: Look[Key]): Specimen {
	const entry = entryOf(key);
	const fitted = typeof value === "number" && entry && entry.kind !== "colour" ? nearestWithin(entry, value) : value;
	return { ...specimen, look: { ...specimen.look, [key]: fitted } };
}

/** Sets the seed: a whole number from 0 to 4294967295, going round at the ends. */
export function withSeed(specimen: Specimen, seed: number): Specimen {
	return { ...specimen, seed: Math.trunc(seed) >>> 0 };
}

/** Takes a berry off by hand; the same specimen where it is off already or `MOST_THINNED` are. */
export function thin(specimen: Specimen, id: number): Specimen {
	const { thinned } = specimen;
	if (thinned.includes(id) || thinned.length >= MOST_THINNED) return specimen;
	return { ...specimen, thinned: [...thinned, id] };
}

/** Puts a berry back that was taken off by hand. */
export function unthin(specimen: Specimen, id: number): Specimen {
	if (!specimen.thinned.includes(id)) return specimen;
	return { ...specimen, thinned: specimen.thinned.filter((each) => each !== id) };
}

/** Puts all of them back. */
export function unthinAll(specimen: Specimen): Specimen {
	return specimen.thinned.length === 0 ? specimen : { ...specimen, thinned: [] };
}
