/**
 * The link of a picture's plant, in the picture's file: a text chunk `tEXt` (ISO/IEC 15948, section 11.3.4.3) with the
 * keyword `Panicle` and the whole address as text. Programs that show or rename pictures preserve it; most of those
 * that save them again do not.
 */

import { crc32 } from "./crc32";
import { FileError } from "./file_error";
import { text } from "./messages.generated";
import { CHUNK_FRAME, PNG_SIGNATURE, pngChunk } from "./png_chunks";

export const LINK_KEYWORD = "Panicle";

const HEADER = "IHDR";
const END = "IEND";
const latin1 = new TextDecoder("latin1");

/**
 * Returns the picture with its plant's link, before the first pixels.
 * @param picture a PNG; any other file is returned unchanged
 * @param link an ASCII address
 */
export async function withLink(picture: Blob, link: string): Promise<Blob> {
	if (!(await isPng(picture))) return picture;
	// The first chunk is the header, of a fixed size.
	const start = PNG_SIGNATURE.length + CHUNK_FRAME + 13;
	const text = pngChunk("tEXt", new TextEncoder().encode(`${LINK_KEYWORD}\0${link}`));
	return new Blob([picture.slice(0, start), text, picture.slice(start)], { type: "image/png" });
}

/** Returns whether a file begins with the signature of PNG. */
export async function isPng(file: Blob): Promise<boolean> {
	const start = new Uint8Array(await file.slice(0, PNG_SIGNATURE.length).arrayBuffer());
	return start.length === PNG_SIGNATURE.length && start.every((byte, i) => byte === PNG_SIGNATURE[i]);
}

/**
 * Returns the link in a PNG, unchecked: never trust it.
 * @param name the file's name, for messages
 * @throws FileError where there is none
 */
export function linkInPng(name: string, bytes: Uint8Array): string {
	for (const { type, data, whole } of chunksOf(name, bytes)) {
		const link = type === "tEXt" ? plainText(data) : type === "iTXt" ? internationalText(data) : undefined;
		if (link === undefined) continue;
		if (!whole) throw broken(name);
		if (!/[?#]/.test(link)) throw new FileError(text.message("picture_bad_link", { file: name }));
		return link;
	}
	throw new FileError(text.message("picture_no_link", { file: name }));
}

interface Chunk {
	readonly type: string;
	readonly data: Uint8Array;
	/** Whether the checksum is right; computed on access. */
	readonly whole: boolean;
}

/**
 * Yields the chunks of a PNG file; `whole` compares a chunk with its checksum. Throws if the file is no PNG or ends
 * early.
 */
function* chunksOf(name: string, bytes: Uint8Array): Generator<Chunk> {
	const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
	for (let at = PNG_SIGNATURE.length, first = true; ; first = false) {
		const remaining = bytes.length - at - CHUNK_FRAME;
		const length = remaining < 0 ? 0 : view.getUint32(at);
		if (remaining < length) throw broken(name);
		const [from, to] = [at + 8, at + 8 + length];
		const type = latin1.decode(bytes.subarray(at + 4, from));
		if (first && type !== HEADER) throw broken(name);
		yield {
			type,
			data: bytes.subarray(from, to),
			get whole() {
				return crc32(bytes.subarray(from - 4, to)) === view.getUint32(to);
			},
		};
		if (type === END) return;
		at += length + CHUNK_FRAME;
	}
}

/** Returns the text after our keyword in a `tEXt` chunk; undefined after another keyword. */
function plainText(data: Uint8Array): string | undefined {
	const [keyword, text] = cut(data);
	return keyword === LINK_KEYWORD ? latin1.decode(text) : undefined;
}

/**
 * Returns the text after our keyword in an `iTXt` chunk, into which some programs turn the former; undefined after
 * another keyword, or where the text is compressed.
 */
function internationalText(data: Uint8Array): string | undefined {
	const [keyword, rest] = cut(data);
	if (keyword !== LINK_KEYWORD || rest[0] !== 0) return undefined;
	// Language, and the keyword in that language.
	const [, translated] = cut(rest.subarray(2));
	const [, text] = cut(translated);
	return new TextDecoder().decode(text);
}

/** Splits bytes at the first zero: the text before it, and the bytes after it; both are empty without a zero. */
function cut(data: Uint8Array): [string, Uint8Array] {
	const end = data.indexOf(0);
	return end < 0 ? ["", data.subarray(0, 0)] : [latin1.decode(data.subarray(0, end)), data.subarray(end + 1)];
}

/** Returns the error of a damaged file. */
const broken = (name: string) => new FileError(text.message("file_broken", { file: name }));
