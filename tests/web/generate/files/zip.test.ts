import { inflateRawSync } from "node:zlib";
import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { zip } from "../../../../web/src/generate/files/zip";

const files = [
	{ name: "bunch.obj", bytes: new TextEncoder().encode("v 0 0 0\n".repeat(5000)) },
	{ name: "Weißer Riesling.mtl", bytes: new TextEncoder().encode("newmtl Skin\n") },
];
const packed = () => zip(files);

describe("zip", () => {
	it("packs files that come out again under their names, much smaller", () => {
		const archive = packed();
		expect(archive.length).toBeLessThan(2000);
		const out = unzipSync(archive);
		expect(Object.keys(out)).toEqual(files.map(({ name }) => name));
		for (const { name, bytes } of files) expect(strFromU8(out[name])).toBe(strFromU8(bytes));
	});

	it("is read by another inflater, by its directory as by its headers", () => {
		const archive = Buffer.from(packed());
		const end = archive.length - 22;
		expect(archive.readUInt32LE(end)).toBe(0x06054b50);
		expect(archive.readUInt16LE(end + 10)).toBe(files.length);
		const entry = archive.readUInt32LE(end + 16);
		const local = archive.readUInt32LE(entry + 42);
		const start = local + 30 + archive.readUInt16LE(local + 26) + archive.readUInt16LE(local + 28);
		const inflated = inflateRawSync(archive.subarray(start, start + archive.readUInt32LE(entry + 20)));
		expect(inflated.equals(Buffer.from(files[0].bytes))).toBe(true);
	});

	it("is the same bytes at any time", async () => {
		const first = packed();
		await new Promise((resolve) => setTimeout(resolve, 5));
		expect(packed()).toEqual(first);
		// 1980-01-01 00:00 in DOS's counting.
		expect(Buffer.from(first).readUInt32LE(10)).toBe(0x00210000);
	});
});
