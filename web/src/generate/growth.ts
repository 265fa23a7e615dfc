/** Growing a specimen of any model, wherever its core lives. */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import { grownMembers, type MembersOptions } from "./members";

/** Has the core of that file (`bunch.wasm`) grow a request. */
export type Run = (wasm: string, blocks: readonly Block[]) => Promise<Answer>;

/** Grows a specimen, and those that stand in it; throws what `run` throws. */
export async function growPlant(
	model: Model,
	specimen: Specimen,
	options: GrowthOptions,
	run: Run,
	members: Omit<MembersOptions, "meshes"> = {},
): Promise<Plant> {
	await model.prepare?.(specimen);
	const grown = model.read(await run(model.wasm, model.encode(specimen, options)), specimen);
	return grownMembers(model, grown, run, { ...members, meshes: options.meshes ?? true });
}

/** The same plant on any machine: how long it took is no part of it. */
export function untimed(plant: Plant): Plant {
	return { ...plant, timings: { grow: 0 } };
}
