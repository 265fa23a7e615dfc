/** What moves a measure: a model's word on which of its parameters do. */
import { withParameters } from "../specimen/edit";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";

/** One number by which a measure can be moved: a parameter, or several that move together. */
export interface Lever<S extends Specimen = Specimen> {
	/** Between which values it can be set; `from` is above 0. */
	readonly from: number;
	readonly to: number;
	/** By which power of it the measure grows, roughly: 3 for a volume by a length; below 0 where it shrinks. */
	readonly power: number;
	/** What it stands at; 0 where it is not set, and is then in the unit of the measure. */
	of(specimen: S): number;
	/** The specimen with it set, as near as the table's limits and steps allow. */
	set(specimen: S, value: number): S;
}

/** The levers of measures by their keys. Of a measure's the first is tried first, the next where that comes to an end. */
export type Levers<S extends Specimen = Specimen> = Readonly<Record<string, readonly Lever<S>[]>>;

/** Parameters that keep their proportions; the first leads, and is the lever's value. */
export function together<S extends Specimen>(
	species: ModelSchema<S>,
	power: number,
	...keys: readonly string[]
): Lever<S> {
	const [lead, ...others] = keys;
	const entry = species.table.entry(lead);
	if (!entry || entry.kind === "colour") throw new RangeError(`${lead} is no number of the ${species.name}.`);
	return {
		power,
		from: entry.min > 0 ? entry.min : entry.kind === "integer" ? 1 : Math.min(entry.step, FINEST),
		to: entry.max,
		of: ({ parameters }) => parameters[lead],
		set: (specimen, value) => {
			const { parameters } = specimen;
			const factor = parameters[lead] > 0 ? value / parameters[lead] : 1;
			const changes = Object.fromEntries(others.map((key) => [key, factor * parameters[key]]));
			return withParameters(species, specimen, { ...changes, [lead]: value });
		},
	};
}

/** The least of a parameter that begins at 0. */
const FINEST = 0.01;
