/** Encodes a specimen as the blocks of a request, listed in wasm-core/src/models/bunch/model.hpp. */
import type { Block } from "../../core/container";
import { CoreError } from "../../core/errors";
import { type TraceRequest, traceBlocks } from "../../plant/derivation_trace";
import { textLengthProblem } from "../../specimen/limits";
import type { CoreEntry } from "../../specimen/table";
import type { Procedure } from "./bunch_plant";
import { INPUT_N_LENGTH } from "./details/inputs";
import { GRAPE_BUNCH_3, GRAPE_BUNCH_4 } from "./grammars.generated";
import { caneLeafBlocks } from "./leaf";
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
	const long = grammar === undefined ? undefined : textLengthProblem(grammar);
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

/** Returns a parameter's value for the core. NaN keeps a text's own `#define`: default values must not override it. */
function parameterValue(entry: CoreEntry, value: number): number {
	if (!Number.isFinite(value)) throw new CoreError("bad request", `${entry.key} is not a number.`);
	return entry.define !== undefined && value === entry.default ? Number.NaN : value;
}

function whole(name: string, value: number): number {
	if (Number.isInteger(value) && value >= 0 && value <= 0xffffffff) return value;
	throw new CoreError("bad request", `${name} is not a whole number from 0 to 4294967295.`);
}
