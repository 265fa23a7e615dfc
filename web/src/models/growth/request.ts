/** Specimen → the blocks of a request, as wasm-core/src/models/growth/model.hpp lists them. */
import type { Block } from "../../core/container";
import { CoreError } from "../../core/errors";
import { leafBlocks } from "../../plant/leaf";
import type { GrowthOptions } from "../model";
import { leafOf } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import { fetchedText } from "./texts";

export interface GrowthRequestOptions extends GrowthOptions {
	/** Whether it is wanted how much of the sky is seen; the default is wherever there are meshes, but not in passing. */
	sky?: boolean;
	/** Whether the fingerprint of the meshes is wanted; the default is no. */
	meshFingerprint?: boolean;
	/** Whether meshes for four distances are wanted, as wasm-core/src/models/growth/model.hpp says; the default is no. */
	levels?: boolean;
	/** How many of them, from near to far; absent: all four. */
	levelCount?: number;
}

/** @throws CoreError where the preset's text has not been fetched, or a parameter is no number */
export function encodeGrowth(specimen: GrowthSpecimen, options: GrowthRequestOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, levels = false, levelCount } = options;
	const { measures = !preview, sky = meshes && !preview } = options;
	const outputs = [
		meshes && "meshes",
		measures && "measures",
		sky && "sky",
		meshFingerprint && "mesh_fingerprint",
		levels && "levels",
	];
	const { model, seed, parameters, surroundings } = specimen;
	const text = fetchedText(specimen);
	if (text === undefined) throw new CoreError("bad request", "The preset's text could not be fetched.");
	const leaf = leafOf(specimen);
	return [
		{ name: "model", data: model },
		{ name: "seed", data: Uint32Array.of(seed) },
		{ name: "outputs", data: outputs.filter(Boolean).join(" ") },
		{
			name: "parameters",
			data: Float32Array.from(GROWTH_TABLE.core, ({ key }) => number(key, parameters[key as keyof typeof parameters])),
		},
		...(levelCount === undefined ? [] : [{ name: "levels", data: Uint32Array.of(levelCount) }]),
		{ name: "rules", data: text },
		...(surroundings ? [{ name: "surroundings", data: Float32Array.from(surroundings) }] : []),
		...(leaf ? leafBlocks(leaf) : []),
	];
}

function number(key: string, value: number): number {
	if (Number.isFinite(value)) return value;
	throw new CoreError("bad request", `${key} is not a number.`);
}
