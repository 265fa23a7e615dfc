/**
 * Changes to a specimen that controls make: always in range, and on steps that a link can hold. A change reuses the
 * objects that it leaves out, so that nothing is redrawn for them.
 */
import type { ModelSchema } from "./model_schema";
import type { Specimen } from "./specimen";
import { nearestWithin } from "./table";

/** Sets parameters; the model's fields adjust others that go with them. */
export function withParameters<S extends Specimen>(
	{ table, details }: ModelSchema<S>,
	specimen: S,
	changes: Readonly<Partial<Record<string, number>>>,
): S {
	if (Object.keys(changes).length === 0) return specimen;
	const parameters: S["parameters"] = { ...specimen.parameters };
	for (const [key, value] of Object.entries(changes)) {
		const entry = table.entry(key);
		if (!entry || entry.look || entry.kind === "colour" || value === undefined || Number.isNaN(value)) continue;
		Object.assign(parameters, { [key]: nearestWithin(entry, value) });
	}
	for (const detail of details) detail.push?.(parameters, changes);
	return { ...specimen, parameters };
}

/** Sets values of the look: colours of six hexadecimal digits, or numbers. */
export function withLook<S extends Specimen>(
	{ table }: ModelSchema<S>,
	specimen: S,
	changes: Readonly<Partial<Record<string, number | string>>>,
): S {
	if (Object.keys(changes).length === 0) return specimen;
	const look: S["look"] = { ...specimen.look };
	for (const [key, value] of Object.entries(changes)) {
		const entry = table.entry(key);
		if (!entry?.look || value === undefined) continue;
		const fitted = typeof value === "number" && entry.kind !== "colour" ? nearestWithin(entry, value) : value;
		Object.assign(look, { [key]: fitted });
	}
	return { ...specimen, look };
}

/** Sets the seed: a whole number from 0 to 4294967295, wrapping around. */
export function withSeed<S extends Specimen>(specimen: S, seed: number): S {
	return { ...specimen, seed: Math.trunc(seed) >>> 0 };
}
