import { inflateSync } from "node:zlib";
import type { Picture } from "../../../web/src/plant/material";

/** The pixels of a PNG as we write it: three chunks, true colour, each row as its difference from the row above. */
export function readPng(file: Uint8Array): Picture {
	const view = new DataView(file.buffer, file.byteOffset);
	const [width, height] = [view.getUint32(16), view.getUint32(20)];
	const rows = inflateSync(file.subarray(41, 41 + view.getUint32(33)));
	const pixels = new Uint8Array(3 * width * height);
	for (let i = 0; i < pixels.length; i++) {
		const row = 3 * width;
		const difference = rows[i + 1 + Math.floor(i / row)];
		pixels[i] = difference + (i >= row ? pixels[i - row] : 0);
	}
	return { width, height, pixels };
}
