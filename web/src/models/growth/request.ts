/** Encodes a specimen as the blocks of a request, listed in wasm-core/src/models/growth/model.hpp. */
import type { Block } from "../../core/container";
import { leafBlocks } from "../../plant/leaf";
import { requestBlocks, requireText } from "../../plant/request";
import type { GrowthOptions } from "../model";
import { type BranchEdit, EDIT_KINDS } from "./edits/branch_edit";
import { leafOf } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import { fetchedText } from "./texts";

export interface GrowthRequestOptions extends GrowthOptions {
	/** Whether to compute sky visibility; default: with meshes, except in previews. */
	sky?: boolean;
	/** Whether to compute the fingerprint of the meshes; default: no. */
	meshFingerprint?: boolean;
	/** Whether to build meshes for four distances (wasm-core/src/models/growth/model.hpp); default: no. */
	levels?: boolean;
	/** Number of levels, from near to far; default: all four. */
	levelCount?: number;
}

/**
 * Encodes a request.
 * @throws CoreError if the preset's text has not been fetched or a parameter is not a number
 */
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
	const { surroundings } = specimen;
	const text = requireText(fetchedText(specimen));
	const leaf = leafOf(specimen);
	return [
		...requestBlocks(specimen, GROWTH_TABLE.core, outputs),
		...(levelCount === undefined ? [] : [{ name: "levels", data: Uint32Array.of(levelCount) }]),
		{ name: "rules", data: text },
		...(surroundings ? [{ name: "surroundings", data: Float32Array.from(surroundings) }] : []),
		...editBlocks(specimen.edits),
		...(leaf ? leafBlocks(leaf) : []),
	];
}

/** Encodes edits of branches (wasm-core/src/models/growth/edits.hpp); none for a plant without. */
function editBlocks(edits: readonly BranchEdit[]): Block[] {
	if (edits.length === 0) return [];
	const records = edits.flatMap((edit) => [
		Number.parseInt(edit.shoot.slice(8), 16),
		Number.parseInt(edit.shoot.slice(0, 8), 16),
		EDIT_KINDS.indexOf(edit.kind),
		"at" in edit ? Math.round(1000 * edit.at) : 0,
		edit.kind === "curve" ? edit.points.length : 0,
	]);
	const points = edits.flatMap((edit) => (edit.kind === "curve" ? edit.points.flat() : []));
	return [
		{ name: "edits", data: Uint32Array.from(records) },
		...(points.length > 0 ? [{ name: "edits.points", data: Float32Array.from(points) }] : []),
	];
}
