import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { compressText, expandText } from "../../../web/src/specimen/compressed_text";

const ROOM = 1 << 16;

describe("a text packed for a link", () => {
	it("comes out as it went in, in letters that addresses leave alone", async () => {
		await fc.assert(
			fc.asyncProperty(fc.string({ unit: "grapheme", maxLength: 200 }), async (text) => {
				const packed = await compressText(text);
				expect(packed).toMatch(/^[A-Za-z0-9_-]*$/);
				expect(await expandText(packed, ROOM)).toBe(text);
			}),
			{ numRuns: 60 },
		);
		expect(await expandText(await compressText("\ufeffa\r\nb\n"), ROOM)).toBe("\ufeffa\r\nb\n");
	});

	it("is unpacked no further than there is room for", async () => {
		const bomb = await compressText("a".repeat(ROOM));
		expect(bomb.length).toBeLessThan(300);
		expect(await expandText(bomb, ROOM)).toHaveLength(ROOM);
		expect(await expandText(bomb, ROOM - 1)).toBeUndefined();
		// Of bytes, not of letters.
		expect(await expandText(await compressText("é"), 1)).toBeUndefined();
		expect(await expandText(await compressText("é"), 2)).toBe("é");
	});

	it("is none where it is damaged", async () => {
		const packed = await compressText("axiom: F(10) S(2)");
		for (const damaged of [packed.slice(2), `${packed}!`, "=", "AAAA"])
			expect(await expandText(damaged, ROOM)).toBeUndefined();
	});
});
