/** Pictures as PNG (ISO/IEC 15948): eight bits per channel; the same pixels give the same bytes. */
import { zlibSync } from "fflate";
import type { Picture } from "../plant/material";
import { PNG_SIGNATURE, pngChunk } from "./png_chunks";

/** Types of colour by the number of channels. */
const COLOUR_TYPES: Readonly<Record<number, number>> = { 1: 0, 3: 2, 4: 6 };
/** The filter "up": differences from the row above, a third smaller for gradients, hardly larger for flat colours. */
const UP = 2;
/** Compression level: the highest, 9, takes twice as long and saves a fiftieth. */
const LEVEL = 6;

/** Encodes a picture; `pixels` are rows from the top: of grey, of red, green and blue, or of these and coverage. */
export function png({ width, height, pixels }: Picture): Uint8Array<ArrayBuffer> {
	const channels = pixels.length / (width * height);
	const header = new Uint8Array(13);
	const view = new DataView(header.buffer);
	view.setUint32(0, width);
	view.setUint32(4, height);
	header.set([8, COLOUR_TYPES[channels]], 8);
	const row = channels * width;
	// Each row begins with its filter. The row above the first one is 0.
	const rows = new Uint8Array((row + 1) * height);
	for (let y = 0; y < height; y++) {
		const to = y * (row + 1);
		rows[to] = UP;
		for (let i = 0; i < row; i++) rows[to + 1 + i] = pixels[y * row + i] - (y > 0 ? pixels[(y - 1) * row + i] : 0);
	}
	const chunks = [
		PNG_SIGNATURE,
		pngChunk("IHDR", header),
		pngChunk("IDAT", zlibSync(rows, { level: LEVEL })),
		pngChunk("IEND", new Uint8Array(0)),
	];
	const file = new Uint8Array(chunks.reduce((sum, { length }) => sum + length, 0));
	let at = 0;
	for (const each of chunks) {
		file.set(each, at);
		at += each.length;
	}
	return file;
}
