import { crc32, inflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { png } from "../../../web/src/formats/png";

/** Type and data of each chunk, its checksum believed to no one. */
function chunksOf(file: Uint8Array): { type: string; data: Uint8Array }[] {
	const view = new DataView(file.buffer, file.byteOffset);
	const chunks = [];
	for (let at = 8; at < file.length; ) {
		const length = view.getUint32(at);
		const whole = file.subarray(at + 4, at + 8 + length);
		expect(view.getUint32(at + 8 + length)).toBe(crc32(whole) >>> 0);
		chunks.push({ type: new TextDecoder().decode(whole.subarray(0, 4)), data: whole.subarray(4) });
		at += 12 + length;
	}
	return chunks;
}

describe("png", () => {
	const pixels = Uint8Array.from({ length: 3 * 3 * 2 }, (_, i) => (i * 37) % 256);

	it("writes a file that others read: signature, header, pixels row by row, end", () => {
		const file = png({ width: 3, height: 2, pixels });
		expect([...file.subarray(0, 8)]).toEqual([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
		const chunks = chunksOf(file);
		expect(chunks.map(({ type }) => type)).toEqual(["IHDR", "IDAT", "IEND"]);
		expect([...chunks[0].data]).toEqual([0, 0, 0, 3, 0, 0, 0, 2, 8, 2, 0, 0, 0]);
		const rows = inflateSync(chunks[1].data);
		// Each row after how it is filtered: 2, to be added to the one above, of bytes.
		expect(rows).toHaveLength(20);
		expect([rows[0], rows[10]]).toEqual([2, 2]);
		expect([...rows.subarray(1, 10)]).toEqual([...pixels.subarray(0, 9)]);
		expect([...rows.subarray(11)].map((value, i) => (value + pixels[i]) % 256)).toEqual([...pixels.subarray(9)]);
	});

	it("gives the same bytes for the same pixels", () => {
		const picture = { width: 3, height: 2, pixels };
		expect(png(picture)).toEqual(png(picture));
	});
});
