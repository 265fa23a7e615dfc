/** Specimen → the blocks of a request, as wasm-core/src/models/bunch/model.hpp lists them. */
import type { Block } from "../../core/container";
import { CoreError } from "../../core/errors";
import { type TraceRequest, traceBlocks } from "../../plant/derivation_trace";
import { overlongText } from "../../specimen/limits";
import type { CoreEntry } from "../../specimen/table";
import type { Procedure } from "./bunch_plant";
import { INPUT_N_LENGTH } from "./details/inputs";
import { GRAPE_BUNCH_3, GRAPE_BUNCH_4 } from "./grammars.generated";
import { caneLeafBlocks } from "./leaf";
import type { NumberKey } from "./parameters.generated";
import { hasLeaves, procedureOf } from "./schema";
import type { BunchSpecimen as Specimen } from "./specimen";
import { BUNCH_TABLE } from "./table";

/** The text that a procedure grows by where a bunch brings none of its own. It goes with every request; the core compiles it once (core/core.ts). */
export const BUILT_IN: Readonly<Record<Procedure, string>> = { paper: GRAPE_BUNCH_3, natural: GRAPE_BUNCH_4 };

export interface BunchRequestOptions {
	/** Whether triangles are wanted besides the skeleton; the default is yes. */
	meshes?: boolean;
	/** Whether `measures` are wanted; the default is yes, but not in passing. */
	measures?: boolean;
	/** Whether the next is on its way; the default is no. */
	preview?: boolean;
	/** Whether it is wanted how much of the sky the meshes' vertices see; the default is wherever there are meshes, but not in passing. */
	sky?: boolean;
	/** Of the derivation; the text's own by default. */
	steps?: number;
	/** Which step of the derivation is to be told; the default is none. */
	trace?: TraceRequest;
	/** Whether the fingerprint of the meshes is wanted; the default is no. */
	meshFingerprint?: boolean;
	/** Sides of a stem's tube; the core's own choice by default. */
	stemSides?: number;
	/** Segments around the berry mesh; the core's own choice by default. */
	berrySegments?: number;
}

/** @throws CoreError where the specimen cannot be written as a request: it has not come through specimen/restore.ts */
export function encodeRequest(specimen: Specimen, options: BunchRequestOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, stemSides = 0, berrySegments = 0, trace } = options;
	const { measures = !preview, sky = meshes && !preview } = options;
	const { inputs, thinned, grammar, parameters } = specimen;
	const long = grammar === undefined ? undefined : overlongText(grammar);
	if (long) {
		throw new CoreError("limit", `The grammar is ${long}; shorten it.`);
	}
	if ((inputs?.n?.length ?? 0) > INPUT_N_LENGTH) {
		throw new CoreError("limit", `n has more than ${INPUT_N_LENGTH} values.`);
	}
	const outputs = [
		meshes && "meshes",
		measures && "measures",
		sky && "sky",
		meshFingerprint && "mesh_fingerprint",
		trace && "chronicle",
	];
	const words = (name: string, values: readonly number[]) => Uint32Array.from(values, (value) => whole(name, value));
	const blocks: Block[] = [
		{ name: "model", data: "bunch" },
		{ name: "seed", data: words("seed", [specimen.seed]) },
		{ name: "outputs", data: outputs.filter(Boolean).join(" ") },
		{
			name: "parameters",
			data: Float32Array.from(BUNCH_TABLE.core, (entry) => parameterValue(entry, parameters[entry.key as NumberKey])),
		},
		{ name: "grammar", data: grammar ?? BUILT_IN[procedureOf(specimen)] },
		{ name: "thinned", data: words("thinned", thinned) },
		{ name: "stem_sides", data: words("stemSides", [stemSides]) },
		{ name: "berry_segments", data: words("berrySegments", [berrySegments]) },
	];
	if (options.steps !== undefined) blocks.push({ name: "steps", data: words("steps", [options.steps]) });
	if (trace) blocks.push(...traceBlocks(trace));
	if (meshes && hasLeaves(specimen)) blocks.push(...caneLeafBlocks());
	if (inputs?.m !== undefined) blocks.push({ name: "m", data: Int32Array.of(whole("m", inputs.m)) });
	if (inputs?.n) blocks.push({ name: "n", data: Int32Array.from(inputs.n, (value) => whole("n", value)) });
	return blocks;
}

/** NaN leaves a `#define` of the text as it stands: one that the person has not moved must not overrule a text's own. */
function parameterValue(entry: CoreEntry, value: number): number {
	if (!Number.isFinite(value)) throw new CoreError("bad request", `${entry.key} is not a number.`);
	return entry.define !== undefined && value === entry.default ? Number.NaN : value;
}

function whole(name: string, value: number): number {
	if (Number.isInteger(value) && value >= 0 && value <= 0xffffffff) return value;
	throw new CoreError("bad request", `${name} is not a whole number from 0 to 4294967295.`);
}
