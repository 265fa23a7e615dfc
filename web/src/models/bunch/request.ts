/** Specimen → the bytes of a request, as boundary/panicle.h lays them out. */
import { GRAMMAR_BYTES, INPUT_N_LENGTH } from "../../specimen/limits";
import type { Specimen } from "../../specimen/specimen";
import { CORE_ENTRIES, type CoreEntry } from "../../specimen/table";
import { CoreError } from "../../core/errors";

const MAGIC = 0x4c434e50; // "PNCL"
const LAYOUT = 2;
const MODEL_BUNCH = 1;
const OUTPUT_MESHES = 1;
const OUTPUT_MEASURES = 2;
const HEADER_WORDS = 12;

export interface RequestOptions {
	/** Whether triangles are wanted besides the skeleton; the default is yes. */
	meshes?: boolean;
	/** Whether `measures` are wanted; the default is yes. */
	measures?: boolean;
	/** Sides of a stem's tube; the core's own choice by default. */
	stemSides?: number;
	/** Segments around the berry mesh; the core's own choice by default. */
	berrySegments?: number;
}

/**
 * @returns the request; little-endian, a whole number of 32-bit words
 * @throws CoreError where the specimen cannot be written as one: it has not come through specimen/restore.ts
 */
export function encodeRequest(specimen: Specimen, options: RequestOptions = {}): Uint8Array<ArrayBuffer> {
	const grammar = new TextEncoder().encode(specimen.grammar ?? "");
	if (grammar.length > GRAMMAR_BYTES) {
		throw new CoreError("limit", `The grammar is longer than ${GRAMMAR_BYTES / 1024} KiB; shorten it.`);
	}
	const n = specimen.inputs?.n ?? [];
	if (n.length > INPUT_N_LENGTH) throw new CoreError("limit", `n has more than ${INPUT_N_LENGTH} values.`);

	const { thinned } = specimen;
	const words = HEADER_WORDS + CORE_ENTRIES.length + n.length + thinned.length;
	const bytes = new Uint8Array((words + Math.ceil(grammar.length / 4)) * 4);
	const view = new DataView(bytes.buffer);
	const header = [
		MAGIC,
		LAYOUT,
		MODEL_BUNCH,
		(options.meshes === false ? 0 : OUTPUT_MESHES) | (options.measures === false ? 0 : OUTPUT_MEASURES),
		whole("seed", specimen.seed),
		whole("stemSides", options.stemSides ?? 0),
		whole("berrySegments", options.berrySegments ?? 0),
		CORE_ENTRIES.length,
		whole("m", specimen.inputs?.m ?? 0),
		n.length,
		grammar.length,
		thinned.length,
	];
	header.forEach((word, index) => {
		view.setUint32(index * 4, word, true);
	});
	CORE_ENTRIES.forEach((entry, index) => {
		view.setFloat32((HEADER_WORDS + index) * 4, asked(entry, specimen.parameters[entry.key]), true);
	});
	n.forEach((value, index) => {
		view.setUint32((HEADER_WORDS + CORE_ENTRIES.length + index) * 4, whole("n", value), true);
	});
	thinned.forEach((id, index) => {
		const at = HEADER_WORDS + CORE_ENTRIES.length + n.length + index;
		view.setUint32(at * 4, whole("thinned", id), true);
	});
	bytes.set(grammar, words * 4);
	return bytes;
}

/** NaN leaves a `#define` of the text as it stands: one that the person has not moved must not overrule a text's own. */
function asked(entry: CoreEntry, value: number): number {
	if (!Number.isFinite(value)) throw new CoreError("bad request", `${entry.key} is not a number.`);
	return entry.define !== undefined && value === entry.default ? Number.NaN : value;
}

function whole(name: string, value: number): number {
	if (Number.isInteger(value) && value >= 0 && value <= 0xffffffff) return value;
	throw new CoreError("bad request", `${name} is not a whole number from 0 to 4294967295.`);
}
