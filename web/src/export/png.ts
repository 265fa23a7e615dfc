/** Pictures as PNG (ISO/IEC 15948): eight bits a channel; the same pixels give the same bytes. */
import { zlibSync } from "fflate";
import type { Picture } from "../plant/material";

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const TRUE_COLOUR = 2;
const CHANNELS = 3;
/** Rows as what they differ by from the row above: a third less of what blends slowly, hardly more of what is flat. */
const UP = 2;
/** The highest, 9, takes twice as long for a fiftieth less. */
const LEVEL = 6;

export function png({ width, height, pixels }: Picture): Uint8Array<ArrayBuffer> {
	const header = new Uint8Array(13);
	const view = new DataView(header.buffer);
	view.setUint32(0, width);
	view.setUint32(4, height);
	header.set([8, TRUE_COLOUR], 8);
	const row = CHANNELS * width;
	// Before each row stands how it is filtered. Above the first one all is 0.
	const rows = new Uint8Array((row + 1) * height);
	for (let y = 0; y < height; y++) {
		const to = y * (row + 1);
		rows[to] = UP;
		for (let i = 0; i < row; i++) rows[to + 1 + i] = pixels[y * row + i] - (y > 0 ? pixels[(y - 1) * row + i] : 0);
	}
	const chunks = [
		chunk("IHDR", header),
		chunk("IDAT", zlibSync(rows, { level: LEVEL })),
		chunk("IEND", new Uint8Array(0)),
	];
	const file = new Uint8Array(SIGNATURE.length + chunks.reduce((sum, { length }) => sum + length, 0));
	file.set(SIGNATURE);
	let at = SIGNATURE.length;
	for (const each of chunks) {
		file.set(each, at);
		at += each.length;
	}
	return file;
}

/** Length, type, data, and the checksum of the latter two. */
function chunk(type: string, data: Uint8Array): Uint8Array {
	const bytes = new Uint8Array(data.length + 12);
	const view = new DataView(bytes.buffer);
	view.setUint32(0, data.length);
	bytes.set(new TextEncoder().encode(type), 4);
	bytes.set(data, 8);
	view.setUint32(data.length + 8, checksum(bytes.subarray(4, data.length + 8)));
	return bytes;
}

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
	let value = byte;
	for (let bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
	return value;
});

/** CRC-32. */
function checksum(bytes: Uint8Array): number {
	let sum = 0xffffffff;
	for (const byte of bytes) sum = TABLE[(sum ^ byte) & 0xff] ^ (sum >>> 8);
	return (sum ^ 0xffffffff) >>> 0;
}
