/** A plant for several distances, for files that hold all of them. */
import type { Levels } from "../../formats/lod_glb";
import type { Model } from "../../models/model";
import type { Specimen } from "../../specimen/specimen";
import type { Growing } from "./make";

/** Undefined of models that make no levels. */
export function levelledOf(model: Model, specimen: Specimen, grow: Growing): Levels | undefined {
	const { levels } = model;
	if (!levels) return undefined;
	return async () => levels(await grow(specimen, { levels: true, meshes: false, measures: false }), specimen);
}
