/** A plant with target measures: parameters are searched for each plant. */
import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { type Solution, type SolverCallbacks, solve } from "../targets/solve";

/** Grows and measures a specimen without meshes. */
export type Measuring = (specimen: Specimen) => Promise<Pick<Plant, "measures">>;

/**
 * Searches for parameters with which a plant reaches its targets. It varies the model's levers: a lever is a parameter,
 * or several that change together, with an effect on a measure (targets/lever.ts).
 * @param from the specimen at which the search begins
 * @param aims the targets: measures and the values that they should have
 * @param grow grows and measures a specimen; called for every trial
 * @param progress called after trials
 * @throws errors of growing
 */
export async function aimed(
	model: Model,
	from: Specimen,
	aims: readonly Aim[],
	grow: Measuring,
	progress?: SolverCallbacks["progress"],
): Promise<Solution> {
	const leversOf = await model.targets?.levers();
	const measures = aims.map(({ measure }) => measure);
	const levers = leversOf?.(from, measures) ?? {};
	const measure = async (specimen: Specimen) => (await grow(specimen)).measures ?? new Float32Array();
	return solve({ table: model.table, from, aims, levers }, { measure, ...(progress ? { progress } : {}) });
}
