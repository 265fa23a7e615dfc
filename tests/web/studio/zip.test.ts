import { inflateRawSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { crc32, zip } from "../../../web/src/studio/files/zip";

const text = (value: string) => new TextEncoder().encode(value);

describe("zip", () => {
	it("has the check value that CRC-32 is known by", () => {
		expect(crc32(text("123456789"))).toBe(0xcbf43926);
	});

	it("packs files that come out again, by its directory as by its headers", async () => {
		const files = [
			{ name: "bunch.obj", bytes: text("v 0 0 0\n".repeat(5000)) },
			{ name: "bunch.mtl", bytes: text("newmtl Skin\n") },
		];
		const archive = Buffer.from(await (await zip(files)).arrayBuffer());
		expect(archive.length).toBeLessThan(2000);
		const end = archive.length - 22;
		expect(archive.readUInt32LE(end)).toBe(0x06054b50);
		expect(archive.readUInt16LE(end + 10)).toBe(2);
		let entry = archive.readUInt32LE(end + 16);
		for (const { name, bytes } of files) {
			expect(archive.readUInt32LE(entry)).toBe(0x02014b50);
			expect(archive.toString("latin1", entry + 46, entry + 46 + name.length)).toBe(name);
			expect(archive.readUInt32LE(entry + 16)).toBe(crc32(bytes));
			const local = archive.readUInt32LE(entry + 42);
			expect(archive.readUInt32LE(local)).toBe(0x04034b50);
			const packed = archive.subarray(
				local + 30 + name.length,
				local + 30 + name.length + archive.readUInt32LE(entry + 20),
			);
			expect(Buffer.from(bytes).equals(inflateRawSync(packed))).toBe(true);
			entry += 46 + name.length;
		}
		expect(entry).toBe(end);
	});
});
