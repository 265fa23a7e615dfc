/**
 * A specimen out of a file that Panicle exported: a GLB (`asset.extras.specimen`) or the JSON document (`specimen`).
 * Files come from anywhere: sizes are checked before anything is read, and what is found goes through
 * specimen/restore.ts like everything from outside.
 */
import { type Restored, restore } from "../specimen/restore";
import { CHUNK_HEADER_BYTES, CHUNK_JSON, GLB_MAGIC, GLB_VERSION, HEADER_BYTES } from "./binary_gltf";

/** A file that holds no specimen; the message names the file and says what to do. */
export class FileError extends Error {
	override name = "FileError";
}

/** Ten times the largest file an export of today's ranges comes to. */
export const FILE_BYTES = 64 * 1024 * 1024;

/**
 * @param name  what the file is called, for messages only: its kind is told from its first bytes
 * @param bytes the whole file
 * @returns a complete specimen in range, with notes on what had to be changed
 * @throws FileError when there is no specimen in it
 */
export function specimenFromFile(name: string, bytes: Uint8Array): Restored {
	if (bytes.length === 0) throw new FileError(`${name} is empty.`);
	if (bytes.length > FILE_BYTES) {
		throw new FileError(`${name} is larger than ${FILE_BYTES / 1024 / 1024} MiB, too large for a file of Panicle's.`);
	}
	const glb = bytes.length >= 4 && view(bytes).getUint32(0, true) === GLB_MAGIC;
	const found = specimenIn(parse(name, glb ? jsonChunk(name, bytes) : bytes));
	if (found === undefined) {
		throw new FileError(`${name} holds no specimen: only files exported by Panicle and not saved again elsewhere do.`);
	}
	return restore(found);
}

function jsonChunk(name: string, bytes: Uint8Array): Uint8Array {
	const start = HEADER_BYTES + CHUNK_HEADER_BYTES;
	const broken = new FileError(`${name} is a damaged or unfinished GLB: export or download it again.`);
	if (bytes.length < start) throw broken;
	const header = view(bytes);
	if (header.getUint32(4, true) !== GLB_VERSION) {
		throw new FileError(`${name} is glTF of version ${header.getUint32(4, true)}; only version 2 can be read.`);
	}
	const length = header.getUint32(HEADER_BYTES, true);
	const type = header.getUint32(HEADER_BYTES + 4, true);
	if (header.getUint32(8, true) > bytes.length || type !== CHUNK_JSON || length > bytes.length - start) throw broken;
	return bytes.subarray(start, start + length);
}

function parse(name: string, bytes: Uint8Array): unknown {
	try {
		return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
	} catch {
		throw new FileError(`${name} is neither a GLB nor readable JSON: drop a GLB or JSON exported by Panicle.`);
	}
}

/** The record at the place either format keeps it; glTF kept as text counts as well. */
function specimenIn(document: unknown): object | undefined {
	const specimen = field(document, "specimen") ?? field(field(field(document, "asset"), "extras"), "specimen");
	return typeof specimen === "object" && specimen !== null && !Array.isArray(specimen) ? specimen : undefined;
}

function field(value: unknown, key: string): unknown {
	return typeof value === "object" && value !== null && Object.hasOwn(value, key)
		? (value as Record<string, unknown>)[key]
		: undefined;
}

function view(bytes: Uint8Array): DataView {
	return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
