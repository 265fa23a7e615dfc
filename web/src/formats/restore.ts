/**
 * Reads a specimen from a file that Panicle exported: a GLB (`asset.extras.specimen`), the JSON document (`specimen`),
 * or a PNG with its link (png_link.ts); or a whole file of saved specimens. Files come from anywhere: sizes are checked
 * before anything is read, only the JSON of a GLB is read, and results must pass through specimen/restore.ts or
 * specimen/link.ts like all data from outside.
 */
import { CHUNK_HEADER_BYTES, CHUNK_JSON, GLB_MAGIC, GLB_VERSION, HEADER_BYTES } from "./binary_gltf";
import { FileError } from "./file_error";
import { isPng, linkInPng } from "./png_link";

export { FileError };

/** The specimen in a file, in one of its forms. */
export type Found = { readonly record: object } | { readonly link: string } | { readonly library: object };

/** The field `format` of a file of saved specimens (docs/saved.md). */
export const LIBRARY_FORMAT = "panicle-library";

const WANTED = "drop a GLB, JSON or PNG exported by Panicle.";

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
	if (file.size === 0) throw new FileError(`${name} is empty.`);
	const picture = await isPng(file);
	const read = picture ? file : await jsonIn(name, file);
	if (read.size > JSON_BYTES) throw new FileError(`${name} is too large: ${WANTED}`);
	const bytes = await read.arrayBuffer();
	if (picture) return { link: linkInPng(name, new Uint8Array(bytes)) };
	const document = parse(name, bytes);
	if (field(document, "format") === LIBRARY_FORMAT) return { library: document as object };
	const record = specimenIn(document);
	if (record === undefined) {
		throw new FileError(`${name} holds no specimen: only files exported by Panicle and not saved again elsewhere do.`);
	}
	return { record };
}

/** The JSON chunk of a GLB; any other file whole. */
async function jsonIn(name: string, file: Blob): Promise<Blob> {
	const start = HEADER_BYTES + CHUNK_HEADER_BYTES;
	const header = new DataView(await file.slice(0, start).arrayBuffer());
	if (header.byteLength < 4 || header.getUint32(0, true) !== GLB_MAGIC) return file;
	const broken = new FileError(`${name} is a damaged or unfinished GLB: export or download it again.`);
	if (header.byteLength < start) throw broken;
	if (header.getUint32(4, true) !== GLB_VERSION) {
		throw new FileError(`${name} is glTF of version ${header.getUint32(4, true)}; only version 2 can be read.`);
	}
	const length = header.getUint32(HEADER_BYTES, true);
	const type = header.getUint32(HEADER_BYTES + 4, true);
	if (header.getUint32(8, true) > file.size || type !== CHUNK_JSON || length > file.size - start) throw broken;
	return file.slice(start, start + length);
}

function parse(name: string, bytes: ArrayBuffer): unknown {
	try {
		return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
	} catch (error) {
		if (!startsAsJson(bytes)) throw new FileError(`${name} is neither a GLB nor readable JSON: ${WANTED}`);
		// JavaScript engines report the position.
		const where = error instanceof Error ? error.message : error;
		throw new FileError(`${name} is damaged or unfinished JSON: export or download it again. (${where})`);
	}
}

const startsAsJson = (bytes: ArrayBuffer) => /^\s*[{[]/.test(new TextDecoder().decode(bytes.slice(0, 64)));

/** The record at the place of either format; glTF stored as text counts as well. */
function specimenIn(document: unknown): object | undefined {
	const specimen = field(document, "specimen") ?? field(field(field(document, "asset"), "extras"), "specimen");
	return typeof specimen === "object" && specimen !== null && !Array.isArray(specimen) ? specimen : undefined;
}

function field(value: unknown, key: string): unknown {
	return typeof value === "object" && value !== null && Object.hasOwn(value, key)
		? (value as Record<string, unknown>)[key]
		: undefined;
}
