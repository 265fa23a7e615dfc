import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { LARGEST_PICTURE } from "../../../../web/src/app/saved/jpeg_size";
import { broughtInWords, readLibrary, writeLibrary } from "../../../../web/src/app/saved/library_file";
import { isSaved, LONGEST_NAME, type Saved, tidyName } from "../../../../web/src/app/saved/saved";
import { foundInFile } from "../../../../web/src/formats/restore";
import { inRun } from "../../../long_run.mjs";
import { savedAs } from "./saved_store";

/** The head of a JPEG of that size, and something after it. */
function jpeg(width = 192, height = 240, bytes = 40): Uint8Array<ArrayBuffer> {
	const head = [
		0xff,
		0xd8,
		0xff,
		0xe0,
		0,
		4,
		0,
		0,
		0xff,
		0xc2,
		0,
		17,
		8,
		height >> 8,
		height & 255,
		width >> 8,
		width & 255,
	];
	const whole = new Uint8Array(bytes);
	whole.set(head);
	return whole;
}

const document = async (saved: readonly Saved[]): Promise<{ specimens: Record<string, unknown>[] }> =>
	JSON.parse(await writeLibrary(saved, 0).text());
const dataUrl = (bytes: Uint8Array) => `data:image/jpeg;base64,${Buffer.from(bytes).toString("base64")}`;

/** Reads a valid specimen with some fields replaced. */
async function withFields(fields: Record<string, unknown>) {
	const written = await document([savedAs("Merlot", { picture: jpeg() })]);
	Object.assign(written.specimens[0], fields);
	return readLibrary(written);
}

const withoutId = ({ id, ...rest }: Saved) => rest;

describe("a library's file", () => {
	it("restores the written specimens, with new ids", async () => {
		const saved = [
			savedAs("Merlot", { link: "?v=2&preset=merlot&seed=7", fingerprint: "0123456789abcdef", picture: jpeg() }),
			savedAs("Blatt “groß” 🍇", { link: "?v=1&model=leaf#g=abc-_", at: Date.UTC(2026, 1, 3) }),
		];
		const file = writeLibrary(saved, 0);
		const found = await foundInFile("mine.panicle.json", file);
		if (!("library" in found)) throw new Error("not told as a library");
		const brought = readLibrary(found.library);
		expect(brought.problems).toEqual([]);
		expect(brought.saved.map(withoutId)).toEqual(saved.map(withoutId));
		expect(brought.saved[0].id).not.toBe(saved[0].id);
		const { specimens } = await document(saved);
		expect(specimens.map(({ model }) => model)).toEqual(["bunch", "leaf"]);
		expect(specimens[0]).toMatchObject({ name: "Merlot", saved: new Date(saved[0].at).toISOString() });
	});

	it("accepts links of any address, and retains query and fragment only", async () => {
		const { saved } = await withFields({ link: "javascript:alert(1)?v=1&preset=grape-15b#g=x" });
		expect(saved[0].link).toBe("?v=1&preset=grape-15b#g=x");
	});

	it.each([
		["name", 3, "No. 1: The name is missing. This plant was skipped."],
		["name", " \u202e\n ", "No. 1: The name is missing. This plant was skipped."],
		["link", ["?v=2"], "No. 1, “Merlot”: The link is not text. This plant was skipped."],
		["link", "https://example.org/", "No. 1, “Merlot”: The link has no “?”. This plant was skipped."],
		["link", `?v=2&x=${"y".repeat(16 * 1024)}`, "No. 1, “Merlot”: The link is too long. This plant was skipped."],
		["link", `?v=2#g=${"y".repeat(512 * 1024)}`, "No. 1, “Merlot”: The link is too long. This plant was skipped."],
	])("leaves out a specimen with an invalid %s, and reports its place: %#", async (field, value, message) => {
		expect(await withFields({ [field]: value })).toEqual({ saved: [], problems: [message] });
	});

	it.each([
		[7, "is not a JPEG"],
		["https://example.org/pixel.gif", "is not a JPEG"],
		["data:image/svg+xml,<svg onload='alert(1)'/>", "is not a JPEG"],
		["data:image/jpeg;base64,!!!", "is damaged"],
		[dataUrl(Uint8Array.of(0x89, 0x50, 0x4e, 0x47)), "is not a JPEG"],
		[dataUrl(jpeg().subarray(0, 12)), "is not a JPEG"],
		[dataUrl(jpeg(60_000, 60_000)), "is larger than 1,024 pixels"],
		[dataUrl(jpeg(1025, 10)), "is larger than 1,024 pixels"],
		[dataUrl(jpeg(192, 240, LARGEST_PICTURE + 1)), "is larger than 96 kB"],
		[`data:image/jpeg;base64,${"A".repeat(4_000_000)}`, "is larger than 96 kB"],
	])("imports a specimen with an invalid picture without it: %#", async (picture, message) => {
		const { saved, problems } = await withFields({ picture });
		expect(problems).toEqual([`No. 1, “Merlot”: The picture ${message}. This plant was imported without a picture.`]);
		expect(saved).toHaveLength(1);
		expect(saved[0].picture).toBeUndefined();
	});

	it("reads a picture of the greatest size", async () => {
		const { saved, problems } = await withFields({ picture: dataUrl(jpeg(1024, 1024, LARGEST_PICTURE)) });
		expect(problems).toEqual([]);
		expect(saved[0].picture).toHaveLength(LARGEST_PICTURE);
	});

	it("ignores invalid dates, versions and fingerprints", async () => {
		const { saved, problems } = await withFields({
			saved: { toString: 3 },
			app: {},
			fingerprint: "<b>",
			picture: null,
		});
		expect(problems).toEqual([]);
		expect(withoutId(saved[0])).toEqual({ name: "Merlot", link: "?v=2", at: 0, app: "" });
	});

	it.each([
		[{ version: 2, specimens: [] }, "The file was written by a newer version of Panicle (file version 2)."],
		[{ specimens: [] }, "The file’s “version” must be 1."],
		[{ version: 1, specimens: {} }, "“specimens” in the file is not a list."],
		[
			{ version: 1, specimens: new Array(10_001).fill(0) },
			"The file has 10,001 plants; at most 10,000 can be imported.",
		],
	])("throws for a document that is no library: %#", (wrong, message) => {
		expect(() => readLibrary({ format: "panicle-library", ...wrong })).toThrow(message);
	});

	it("is distinguished from other JSON; a truncated one is reported as damaged", async () => {
		const text = await writeLibrary([savedAs("Merlot")], 0).text();
		await expect(foundInFile("cut.panicle.json", new Blob([text.slice(0, 90)]))).rejects.toThrow(
			/^cut\.panicle\.json is damaged or incomplete\. Export or download it again\. \(.+\)$/,
		);
		await expect(foundInFile("other.json", new Blob(['{"format":"else"}']))).rejects.toThrow("wasn’t made by Panicle");
	});

	it("throws only LibraryError, and imports only specimens that can be stored, for any content", () => {
		const any = fc.jsonValue({ maxDepth: 2 });
		const near = fc.record(
			{
				name: fc.oneof(fc.string({ unit: "binary" }), any),
				link: fc.oneof(
					fc.constant("?v=2"),
					fc.string().map((text) => `https://a.example/?${text}`),
					any,
				),
				picture: fc.oneof(
					fc.base64String().map((text) => `data:image/jpeg;base64,${text}`),
					any,
				),
				saved: any,
				app: any,
				fingerprint: any,
			},
			{ requiredKeys: [] },
		);
		const list = fc.oneof(fc.array(fc.oneof(near, any), { maxLength: 6 }), any);
		fc.assert(
			fc.property(list, fc.oneof(fc.constant(1), any), (specimens, version) => {
				let brought: ReturnType<typeof readLibrary>;
				try {
					brought = readLibrary({ format: "panicle-library", version, specimens });
				} catch (error) {
					expect((error as Error).name).toBe("LibraryError");
					return;
				}
				for (const saved of brought.saved) {
					expect(isSaved(structuredClone(saved))).toBe(true);
					expect(saved.name).toBe(tidyName(saved.name));
					expect(saved.name).not.toBe("");
				}
				expect(brought.saved.length + brought.problems.length).toBeGreaterThanOrEqual((specimens as []).length);
			}),
			{ numRuns: inRun(25, 100) },
		);
	});
});

it("describes an import in few lines", () => {
	const one = savedAs("Merlot");
	expect(broughtInWords({ saved: [one, one], problems: [] }, 2)).toEqual({ text: "Plants imported: 2.", lines: [] });
	expect(broughtInWords({ saved: [one, one], problems: ["a"] }, 1)).toEqual({
		text: "Plants imported: 1. Already here: 1.",
		lines: ["a"],
	});
	expect(broughtInWords({ saved: [one], problems: [] }, 0).text).toBe(
		"Nothing was imported: the plant is already here.",
	);
	const { lines } = broughtInWords({ saved: [], problems: new Array(500).fill("wrong") }, 0);
	expect([lines.length, lines.at(-1)]).toEqual([9, "…and 492 more."]);
});

it("reduces a name to one line without direction marks, truncated", () => {
	expect(tidyName("  Merlot\n\tno. 2 ")).toBe("Merlot no. 2");
	expect(tidyName("Mer\u202elot\u2066")).toBe("Merlot");
	expect(Array.from(tidyName("🍇".repeat(1_000_000)))).toHaveLength(LONGEST_NAME);
});
