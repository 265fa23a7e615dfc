import fc from "fast-check";
import { expect, it } from "vitest";
import { inRun } from "../long_run.mjs";
import { decodeLink, ENTRIES, encodeLink } from "../web/bunch";
import { faults } from "../web/specimen/arbitrary";

const KEYS = [
	...new Set([
		"v",
		"model",
		"preset",
		"seed",
		"m",
		"n",
		"g",
		"thin",
		"thinned",
		...ENTRIES.flatMap(({ key, link }) => [key, link]),
	]),
];
const VALUES = [
	"",
	"1",
	"-1",
	"0",
	"1e9",
	"79,76",
	",",
	"1,2,3",
	"%",
	"%00",
	"+",
	"NaN",
	"duku",
	"paper",
	"a.1z.hra0hr",
	"ffffff",
	"[object Object]",
];

const noise = fc.string({ unit: "binary", maxLength: 200 });
const part = fc.tuple(fc.oneof(fc.constantFrom(...KEYS), noise), fc.oneof(fc.constantFrom(...VALUES), noise));
const query = fc.oneof(
	noise,
	fc.array(part, { maxLength: 40 }).map((parts) => `?${parts.map(([key, value]) => `${key}=${value}`).join("&")}`),
);
const base64 = fc.stringMatching(/^[A-Za-z0-9_-]{0,300}$/);
const fragment = fc.oneof(
	noise,
	base64.map((text) => `#g=${text}`),
);

it("any address whatever gives a specimen in range, whose own link brings it back", async () => {
	await fc.assert(
		fc.asyncProperty(query, fragment, async (search, hash) => {
			const { specimen, notes } = await decodeLink(search, hash);
			expect(faults(specimen)).toEqual([]);
			for (const { text } of notes) expect(text).toMatch(/^[^\n]{1,200}$/);
			const link = new URL(await encodeLink(specimen), "https://example.org/");
			expect(await decodeLink(link.search, link.hash)).toEqual({ specimen, notes: [] });
		}),
		{ numRuns: inRun(500, 3000) },
	);
});

it("an address of any length is read", async () => {
	const long = "&l=1".repeat(1_000_000);
	expect(faults((await decodeLink(long, `#g=${"A".repeat(5_000_000)}`)).specimen)).toEqual([]);
});
