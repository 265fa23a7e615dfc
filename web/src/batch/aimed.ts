/** A plant with target measures: parameters are searched for each plant. */
import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { type Solution, type SolverCallbacks, solve } from "../targets/solve";

/** Grows and measures a specimen without meshes. */
export type Measuring = (specimen: Specimen) => Promise<Pick<Plant, "measures">>;

/** @throws errors of growing */
export async function aimed(
	model: Model,
	from: Specimen,
	aims: readonly Aim[],
	grow: Measuring,
	progress?: SolverCallbacks["progress"],
): Promise<Solution> {
	const levers = (await model.targets?.levers())?.(
		from,
		aims.map(({ measure }) => measure),
	);
	const measure = async (specimen: Specimen) => (await grow(specimen)).measures ?? new Float32Array();
	return solve(
		{ table: model.table, from, aims, levers: levers ?? {} },
		{ measure, ...(progress ? { progress } : {}) },
	);
}
