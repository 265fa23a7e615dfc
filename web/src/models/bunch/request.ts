/** Encodes a specimen as the blocks of a request, listed in wasm-core/src/models/bunch/model.hpp. */

import type { Block } from "../../core/container";
import { CoreError } from "../../core/errors";
import { type TraceRequest, traceBlocks } from "../../plant/derivation_trace";
import { finiteNumber, tooLong } from "../../plant/request";
import { GRAMMAR_BYTES, textLengthProblem } from "../../specimen/limits";
import type { CoreEntry } from "../../specimen/table";
import type { Procedure } from "./bunch_plant";
import { INPUT_N_LENGTH } from "./details/inputs";
import { GRAPE_BUNCH_3, GRAPE_BUNCH_4 } from "./grammars.generated";
import { caneLeafBlocks } from "./leaf";
import { text } from "./messages.generated";
import type { NumberKey } from "./parameters.generated";
import { hasLeaves, procedureOf } from "./schema";
import type { BunchSpecimen as Specimen } from "./specimen";
import { BUNCH_TABLE } from "./table";

/**
 * Built-in text of each procedure, for bunches without a text of their own. Every request contains it; the core
 * compiles it once (core/core.ts).
 */
export const BUILT_IN: Readonly<Record<Procedure, string>> = { paper: GRAPE_BUNCH_3, natural: GRAPE_BUNCH_4 };

export interface BunchRequestOptions {
	/** Whether to build meshes besides the skeleton; default: yes. */
	meshes?: boolean;
	/** Whether to compute measures; default: yes, except in previews. */
	measures?: boolean;
	/** Whether this is a preview, to be followed by another growth; default: no. */
	preview?: boolean;
	/** Whether to compute the vertices' sky visibility; default: with meshes, except in previews. */
	sky?: boolean;
	/** Number of derivation steps; default: the text's own. */
	steps?: number;
	/** Step of the derivation to trace; default: none. */
	trace?: TraceRequest;
	/** Whether to compute the fingerprint of the meshes; default: no. */
	meshFingerprint?: boolean;
	/** Sides of a stem's tube; default: the core's choice. */
	stemSides?: number;
	/** Segments around the berry mesh; default: the core's choice. */
	berrySegments?: number;
}

/**
 * Encodes a request.
 * @throws CoreError if the specimen is invalid: one that has not passed specimen/restore.ts
 */
export function encodeRequest(specimen: Specimen, options: BunchRequestOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, stemSides = 0, berrySegments = 0, trace } = options;
	const { measures = !preview, sky = meshes && !preview } = options;
	const { inputs, thinned, grammar, parameters } = specimen;
	if (grammar !== undefined && textLengthProblem(grammar)) {
		throw tooLong(GRAMMAR_BYTES);
	}
	if ((inputs?.n?.length ?? 0) > INPUT_N_LENGTH) {
		throw new CoreError("limit", text.message("too_many_n", { most: INPUT_N_LENGTH }));
	}
	const outputs = [
		meshes && "meshes",
		measures && "measures",
		sky && "sky",
		meshFingerprint && "mesh_fingerprint",
		trace && "chronicle",
	];
	const wholeNumbers = (name: string, values: readonly number[]) =>
		Uint32Array.from(values, (value) => checkedWhole(name, value));
	const blocks: Block[] = [
		{ name: "model", data: "bunch" },
		{ name: "seed", data: wholeNumbers("seed", [specimen.seed]) },
		{ name: "outputs", data: outputs.filter(Boolean).join(" ") },
		{
			name: "parameters",
			data: Float32Array.from(BUNCH_TABLE.core, (entry) => parameterValue(entry, parameters[entry.key as NumberKey])),
		},
		{ name: "grammar", data: grammar ?? BUILT_IN[procedureOf(specimen)] },
		{ name: "thinned", data: wholeNumbers("thinned", thinned) },
		{ name: "stem_sides", data: wholeNumbers("stemSides", [stemSides]) },
		{ name: "berry_segments", data: wholeNumbers("berrySegments", [berrySegments]) },
	];
	if (options.steps !== undefined) blocks.push({ name: "steps", data: wholeNumbers("steps", [options.steps]) });
	if (trace) blocks.push(...traceBlocks(trace));
	if (meshes && hasLeaves(specimen)) blocks.push(...caneLeafBlocks());
	if (inputs?.m !== undefined) blocks.push({ name: "m", data: Int32Array.of(checkedWhole("m", inputs.m)) });
	if (inputs?.n) blocks.push({ name: "n", data: Int32Array.from(inputs.n, (value) => checkedWhole("n", value)) });
	return blocks;
}

/** Returns a parameter's value for the core. NaN keeps a text's own `#define`: default values must not override it. */
function parameterValue(entry: CoreEntry, value: number): number {
	const number = finiteNumber(entry.key, value);
	return entry.define !== undefined && number === entry.default ? Number.NaN : number;
}

/** Returns a number that fits an unsigned integer of 32 bits; throws a CoreError for others. */
function checkedWhole(name: string, value: number): number {
	if (Number.isInteger(value) && value >= 0 && value <= 0xffffffff) return value;
	throw new CoreError("bad request", text.message("not_whole", { name, most: "4294967295" }));
}
