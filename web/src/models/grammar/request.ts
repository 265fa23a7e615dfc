/** Encodes a specimen as the blocks of a request, listed in wasm-core/src/models/grammar/model.hpp. */
import type { Block } from "../../core/container";
import { traceBlocks } from "../../plant/derivation_trace";
import { finiteNumber, requestBlocks, requireText } from "../../plant/request";
import type { GrowthOptions } from "../model";
import { areaBlocks } from "./areas/blocks";
import type { GrammarSpecimen } from "./specimen";
import { GRAMMAR_TABLE } from "./table";
import { fetchedText } from "./texts";

export interface GrammarRequestOptions extends GrowthOptions {
	/** Whether to compute sky visibility; default: with meshes, except in previews. */
	sky?: boolean;
	/** Whether to compute the fingerprint of the meshes; default: no. */
	meshFingerprint?: boolean;
}

/**
 * Encodes a request.
 * @throws CoreError if the preset's text has not been fetched or a parameter is not a number
 */
export function encodeGrammar(specimen: GrammarSpecimen, options: GrammarRequestOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, string = false, trace } = options;
	const { measures = !preview, sky = meshes && !preview } = options;
	const outputs = [
		meshes && "meshes",
		measures && "measures",
		sky && "sky",
		preview && "coarse",
		meshFingerprint && "mesh_fingerprint",
		string && "string",
		trace && "chronicle",
	];
	const { constants, steps: own } = specimen;
	const { steps = own } = options;
	const text = requireText(fetchedText(specimen));
	const names = Object.keys(constants);
	return [
		...requestBlocks(specimen, GRAMMAR_TABLE.core, outputs),
		...(steps === undefined ? [] : [{ name: "steps", data: Uint32Array.of(steps) }]),
		...(names.length === 0
			? []
			: [
					{ name: "constants.names", data: names.join("\n") },
					{ name: "constants.values", data: Float32Array.from(names, (name) => finiteNumber(name, constants[name])) },
				]),
		...areaBlocks(specimen),
		...(trace ? traceBlocks(trace) : []),
		{ name: "grammar", data: text },
	];
}
