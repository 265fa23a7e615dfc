/**
 * Reads a specimen from a file that Panicle exported: a GLB (`asset.extras.specimen`), the JSON document (`specimen`),
 * or a PNG with its link (png_link.ts); or a whole file of saved specimens. Files come from anywhere: sizes are checked
 * before anything is read, only the JSON of a GLB is read, and results must pass through specimen/restore.ts or
 * specimen/link.ts like all data from outside.
 */
import { fieldOf, isRecord } from "../specimen/read_values";
import { CHUNK_HEADER_BYTES, CHUNK_JSON, GLB_MAGIC, GLB_VERSION, HEADER_BYTES } from "./binary_gltf";
import { FileError } from "./file_error";
import { text } from "./messages.generated";
import { isPng, linkInPng } from "./png_link";

export { FileError };

/** The specimen in a file, in one of its forms. */
export type Found = { readonly record: object } | { readonly link: string } | { readonly library: object };

/** The field `format` of a file of saved specimens (docs/saved.md). */
export const LIBRARY_FORMAT = "panicle-library";

/**
 * The most bytes of JSON or of a picture that are read. A plant has at most 100 000 segments
 * (wasm-core/src/foundation/limits.hpp), so no export reaches half of this; the meshes of a GLB, which may be far
 * larger, do not count.
 */
export const JSON_BYTES = 128 * 1024 * 1024;

/**
 * Finds the specimen in a file.
 * @param name the file's name, for messages only: the first bytes decide its kind
 * @param file the whole file, of any size
 * @returns the record of a specimen as it is in the file, or the link, of any model; or the document of a library
 * @throws FileError when there is none
 */
export async function foundInFile(name: string, file: Blob): Promise<Found> {
	if (file.size === 0) throw new FileError(text.message("file_empty", { file: name }));
	const picture = await isPng(file);
	const read = picture ? file : await jsonIn(name, file);
	if (read.size > JSON_BYTES) throw new FileError(text.message("file_too_large", { file: name }));
	const bytes = await read.arrayBuffer();
	if (picture) return { link: linkInPng(name, new Uint8Array(bytes)) };
	const document = parse(name, bytes);
	if (fieldOf(document, "format") === LIBRARY_FORMAT) return { library: document as object };
	const record = specimenIn(document);
	if (record === undefined) {
		throw new FileError(text.message("file_no_plant", { file: name }));
	}
	return { record };
}

/** Returns the JSON chunk of a GLB; any other file whole. */
async function jsonIn(name: string, file: Blob): Promise<Blob> {
	const start = HEADER_BYTES + CHUNK_HEADER_BYTES;
	const header = new DataView(await file.slice(0, start).arrayBuffer());
	if (header.byteLength < 4 || header.getUint32(0, true) !== GLB_MAGIC) return file;
	const broken = new FileError(text.message("file_broken", { file: name }));
	if (header.byteLength < start) throw broken;
	if (header.getUint32(4, true) !== GLB_VERSION) {
		const version = `${header.getUint32(4, true)}`;
		throw new FileError(text.message("file_gltf_version", { file: name, version }));
	}
	const length = header.getUint32(HEADER_BYTES, true);
	const type = header.getUint32(HEADER_BYTES + 4, true);
	if (header.getUint32(8, true) > file.size || type !== CHUNK_JSON || length > file.size - start) throw broken;
	return file.slice(start, start + length);
}

/**
 * Parses a JSON file.
 * @throws FileError if the file is not JSON, with the parser's report if it begins like JSON
 */
function parse(name: string, bytes: ArrayBuffer): unknown {
	try {
		return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
	} catch (error) {
		if (!startsAsJson(bytes)) throw new FileError(text.message("file_unknown", { file: name }));
		// JavaScript engines report the position.
		const problem = error instanceof Error ? error.message : String(error);
		throw new FileError(text.message("file_broken_json", { file: name, problem }));
	}
}

/** Returns whether a file begins like a JSON object or list. */
const startsAsJson = (bytes: ArrayBuffer) => /^\s*[{[]/.test(new TextDecoder().decode(bytes.slice(0, 64)));

/**
 * Returns the record of the specimen in a document, where either format has it; glTF stored as text counts as well.
 */
function specimenIn(document: unknown): object | undefined {
	const specimen = fieldOf(document, "specimen") ?? fieldOf(fieldOf(fieldOf(document, "asset"), "extras"), "specimen");
	return isRecord(specimen) ? specimen : undefined;
}
