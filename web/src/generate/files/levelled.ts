/** A plant at several levels of detail, for files that hold all of them. */
import type { Levels } from "../../formats/lod_glb";
import type { GrowthOptions, Model } from "../../models/model";
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";

/** Grows a specimen, with its meshes by default. */
export type GrowSpecimen = (specimen: Specimen, wanted?: GrowthOptions) => Promise<Plant>;

/** Returns a function that grows a specimen's levels of detail; undefined for models without levels. */
export function levelledOf(model: Model, specimen: Specimen, grow: GrowSpecimen): Levels | undefined {
	const { levels } = model;
	if (!levels) return undefined;
	return async () => levels(await grow(specimen, { levels: true, meshes: false, measures: false }), specimen);
}
