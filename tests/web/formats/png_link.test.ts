import { crc32, deflateSync } from "node:zlib";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { png } from "../../../web/src/formats/png";
import { withLink } from "../../../web/src/formats/png_link";
import { FileError, foundInFile } from "../../../web/src/formats/restore";
import { inRun } from "../../long_run.mjs";
import { readPng } from "./reading_png";

const LINK = "https://plants.example/app/?v=2&preset=riesling&seed=7&l=99.5#g=Ab-_9";
const picture = { width: 3, height: 2, pixels: Uint8Array.from({ length: 18 }, (_, i) => 13 * i) };
const bare = png(picture);
const linked = await bytesOf(await withLink(new Blob([bare]), LINK));

async function bytesOf(blob: Blob): Promise<Uint8Array<ArrayBuffer>> {
	return new Uint8Array(await blob.arrayBuffer());
}
const open = (...parts: BlobPart[]) => foundInFile("plant.png", new Blob(parts));

/** A chunk written by the standard, independent of the code under test. */
function chunk(type: string, data: string | Uint8Array): Uint8Array<ArrayBuffer> {
	const body = Buffer.concat([Buffer.from(type, "latin1"), Buffer.from(data as string, "latin1")]);
	const length = Buffer.alloc(4);
	length.writeUInt32BE(body.length - 4);
	const sum = Buffer.alloc(4);
	sum.writeUInt32BE(crc32(body) >>> 0);
	return new Uint8Array(Buffer.concat([length, body, sum]));
}
/** The picture with chunks of another program before its end. */
const saved = (...chunks: Uint8Array<ArrayBuffer>[]) => [
	bare.subarray(0, bare.length - 12),
	...chunks,
	bare.subarray(-12),
];

describe("a picture’s link", () => {
	it("stands in a text chunk right after the header, and leaves the picture as it was", async () => {
		expect(linked.length).toBe(bare.length + 12 + "Panicle\0".length + LINK.length);
		expect([...linked.subarray(33, 45 + 8 + LINK.length)]).toEqual([...chunk("tEXt", `Panicle\0${LINK}`)]);
		const without = Buffer.concat([linked.subarray(0, 33), linked.subarray(45 + 8 + LINK.length)]);
		expect(readPng(without)).toEqual(picture);
		expect(await open(linked)).toEqual({ link: LINK });
	});

	it("is put into PNGs alone", async () => {
		const other = new Blob(["GIF89a"], { type: "image/gif" });
		expect(await withLink(other, LINK)).toBe(other);
	});

	it("is found where other programs put it: after the pixels, or as international text", async () => {
		const other = chunk("tEXt", "Comment\0Panicle\0?v=2");
		expect(await open(...saved(other, chunk("tEXt", `Panicle\0${LINK}`)))).toEqual({ link: LINK });
		expect(await open(...saved(other, chunk("iTXt", `Panicle\0\0\0en\0Rispe\0${LINK}`)))).toEqual({ link: LINK });
	});

	it.each([
		["without a link", [bare], "has no link to a plant"],
		["of another program’s words", saved(chunk("tEXt", "Software\0?v=2")), "has no link to a plant"],
		["with packed text", saved(chunk("iTXt", "Panicle\0\x01\0\0\0x")), "has no link to a plant"],
		["with no link in its place", saved(chunk("tEXt", "Panicle\0grapes")), "contains is not valid"],
		["cut short", [bare.subarray(0, bare.length - 1)], "is damaged or incomplete"],
		["cut before its end", [bare.subarray(0, bare.length - 12)], "is damaged or incomplete"],
		["of a signature", [bare.subarray(0, 8)], "is damaged or incomplete"],
		["without its header", [bare.subarray(0, 8), bare.subarray(33)], "is damaged or incomplete"],
		["with a damaged link", [linked.with(60, 0x41)], "is damaged or incomplete"],
	])("says what is wrong with a picture %s", async (_, parts, message) => {
		await expect(open(...parts)).rejects.toThrow(FileError);
		await expect(open(...parts)).rejects.toThrow(`plant.png ${message}`);
	});

	it("is found or refused in a picture with any damage", () =>
		fc.assert(
			fc.asyncProperty(
				fc.array(fc.tuple(fc.nat(linked.length - 1), fc.nat(255)), { minLength: 1, maxLength: 6 }),
				fc.nat(linked.length),
				async (changes, length) => {
					const file = linked.slice();
					for (const [at, value] of changes) file[at] = value;
					for (const each of [file, file.subarray(0, length)]) {
						const found = await open(each).catch((error: unknown) => error);
						if (found instanceof Error) expect(found).toBeInstanceOf(FileError);
						else expect(found).toEqual({ link: LINK });
					}
				},
			),
			{ numRuns: inRun(150, 500) },
		));

	it("is found in a picture of many chunks", async () => {
		const pixels = chunk("IDAT", deflateSync(Buffer.alloc(4096)));
		const many = Array.from({ length: 20_000 }, () => pixels);
		expect(await open(...saved(...many, chunk("tEXt", `Panicle\0${LINK}`)))).toEqual({ link: LINK });
	});
});
