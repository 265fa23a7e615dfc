/** Levers: the parameters of a model that change a measure. */
import { withParameters } from "../specimen/edit";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";

/** A number that changes a measure: a parameter, or several that change together. */
export interface Lever<S extends Specimen = Specimen> {
	/** The range of the lever; `from` is above 0. */
	readonly from: number;
	readonly to: number;
	/**
	 * The power of the lever with which the measure grows, roughly: 3 for a volume by a length; below 0 where it
	 * shrinks.
	 */
	readonly power: number;
	/** The lever's value; 0 where it is not set, and then in the unit of the measure. */
	of(specimen: S): number;
	/** The specimen with the lever set, as near as the table's limits and steps allow. */
	set(specimen: S, value: number): S;
}

/** Levers by the key of the measure. The first is tried first, the next one when that reaches its limit. */
export type Levers<S extends Specimen = Specimen> = Readonly<Record<string, readonly Lever<S>[]>>;

/**
 * Returns a lever of parameters that change in proportion; the first one is the lever's value.
 * @param power as `Lever.power`
 */
export function proportionalLever<S extends Specimen>(
	schema: ModelSchema<S>,
	power: number,
	...keys: readonly string[]
): Lever<S> {
	const [lead, ...others] = keys;
	const entry = schema.table.entry(lead);
	if (!entry || entry.kind === "colour") throw new RangeError(`${lead} is no number of the ${schema.name}.`);
	return {
		power,
		from: entry.min > 0 ? entry.min : entry.kind === "integer" ? 1 : Math.min(entry.step, FINEST),
		to: entry.max,
		of: ({ parameters }) => parameters[lead],
		set: (specimen, value) => {
			const { parameters } = specimen;
			const factor = parameters[lead] > 0 ? value / parameters[lead] : 1;
			const changes = Object.fromEntries(others.map((key) => [key, factor * parameters[key]]));
			return withParameters(schema, specimen, { ...changes, [lead]: value });
		},
	};
}

/** The least value of a parameter whose range begins at 0. */
const FINEST = 0.01;
