/** Encodes a specimen as the blocks of a request, listed in wasm-core/src/models/flower/model.hpp. */
import type { Block } from "../../core/container";
import { finiteNumber, requestBlocks, requireText } from "../../plant/request";
import type { GrowthOptions } from "../model";
import type { FlowerSpecimen } from "./specimen";
import { FLOWER_TABLE } from "./table";
import { fetchedText } from "./texts";

export interface FlowerRequestOptions extends GrowthOptions {
	/** Whether to compute sky visibility; default: with meshes, except in previews. */
	sky?: boolean;
	/** Whether to compute the fingerprint of the meshes; default: no. */
	meshFingerprint?: boolean;
}

/**
 * Encodes a request.
 * @throws CoreError if the preset's text has not been fetched or a parameter is not a number
 */
export function encodeFlower(specimen: FlowerSpecimen, options: FlowerRequestOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, levels = false } = options;
	const { measures = !preview, sky = meshes && !preview, map = !preview && !levels } = options;
	const outputs = [
		// The surface area is measured on the mesh, so that it must not depend on whether meshes were requested.
		(meshes || measures) && "meshes",
		measures && "measures",
		sky && "sky",
		map && "map",
		meshFingerprint && "mesh_fingerprint",
		levels && "levels",
	];
	const { constants } = specimen;
	const text = requireText(fetchedText(specimen));
	const names = Object.keys(constants);
	return [
		...requestBlocks(specimen, FLOWER_TABLE.core, outputs),
		...(names.length === 0
			? []
			: [
					{ name: "values.names", data: names.join(" ") },
					{ name: "values", data: Float32Array.from(names, (name) => finiteNumber(name, constants[name])) },
				]),
		{ name: "text", data: text },
	];
}
