/** The structure of a PNG (ISO/IEC 15948, section 5): a signature, then chunks. */
import { crc32 } from "./crc32";

export const PNG_SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);

/** Bytes of a chunk besides its data: length and type before it, the checksum of type and data after it. */
export const CHUNK_FRAME = 12;

/**
 * Returns a whole chunk: length, type, data and checksum.
 * @param type four letters
 */
export function pngChunk(type: string, data: Uint8Array): Uint8Array<ArrayBuffer> {
	const bytes = new Uint8Array(data.length + CHUNK_FRAME);
	const view = new DataView(bytes.buffer);
	view.setUint32(0, data.length);
	bytes.set(new TextEncoder().encode(type), 4);
	bytes.set(data, 8);
	view.setUint32(data.length + 8, crc32(bytes.subarray(4, data.length + 8)));
	return bytes;
}
