/** Grows a specimen of any model, wherever its core runs. */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import { grownMembers, type MembersOptions } from "./members";
import { readable, readablePlant } from "./readable";

/** Runs a request in the core of a file (`bunch.wasm`). */
export type RunCore = (wasm: string, blocks: readonly Block[]) => Promise<Answer>;

/** Grows a specimen and its members; rejects as `run` does. */
export async function growPlant(
	model: Model,
	specimen: Specimen,
	options: GrowthOptions,
	run: RunCore,
	members: Omit<MembersOptions, "meshes"> = {},
): Promise<Plant> {
	await model.prepare?.(specimen);
	const answer = await readable(run)(model.wasm, model.encode(specimen, options));
	const grown = await readablePlant(model.read(answer, specimen));
	return grownMembers(model, grown, run, { ...members, meshes: options.meshes ?? true });
}

/** Returns the plant without the time that growing took: the same on any machine. */
export function untimed(plant: Plant): Plant {
	return { ...plant, timings: { grow: 0 } };
}
