import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { movePoint } from "../../../../web/src/models/leaf/outline/points";
import { LEAF, leafFromPreset } from "../../../../web/src/models/leaf/schema";
import type { LeafSpecimen } from "../../../../web/src/models/leaf/specimen";
import { decodeLink, encodeLink, encodeQuery } from "../../../../web/src/specimen/link";
import { restore } from "../../../../web/src/specimen/restore";
import { growsAlike, sameSpecimen } from "../../../../web/src/specimen/same";
import { writtenSpecimen } from "../../../../web/src/specimen/written";

const grapevine = leafFromPreset("grapevine");
const altered: LeafSpecimen = {
	...grapevine,
	outline: movePoint(grapevine.outline, 5, { x: 0.6, y: -0.2 }, { mirror: true }),
};
const texts = (read: { notes: readonly { text: string }[] }) => read.notes.map(({ text }) => text);

describe("the outline in the document", () => {
	it.each(LEAF.presets.list.map(({ name }) => name))("%s links to itself, without a word about its outline", (name) => {
		const query = encodeQuery(LEAF, leafFromPreset(name));
		expect(query).not.toMatch(/[?&]o=/);
		expect(restore(LEAF, { v: 2, model: "leaf", preset: name })).toEqual({ specimen: leafFromPreset(name), notes: [] });
	});

	it("comes back from a link of fewer than 300 characters", async () => {
		const link = await encodeLink(LEAF, altered);
		expect(link.length).toBeLessThan(300);
		expect(await decodeLink(LEAF, link)).toEqual({ specimen: altered, notes: [] });
	});

	it("takes fewer than 300 characters where the largest preset has one side of its own", () => {
		const oak = leafFromPreset("oak");
		const crooked = { ...oak, outline: movePoint(oak.outline, 5, { x: 0.2, y: 0.2 }, { mirror: false }) };
		expect(encodeQuery(LEAF, crooked).length).toBeLessThan(300);
	});

	it("comes back from a file", () => {
		const written = JSON.parse(JSON.stringify(writtenSpecimen(LEAF, altered)));
		expect(written.outline[1]).toEqual({ x: 0.044, y: -0.11, kind: "smooth" });
		expect(restore(LEAF, written)).toEqual({ specimen: altered, notes: [] });
	});

	it("distinguishes leaves with other outlines", () => {
		expect(sameSpecimen(grapevine, leafFromPreset("grapevine"))).toBe(true);
		expect(growsAlike(grapevine, altered)).toBe(false);
	});

	it.each([
		["AAA", "o: “AAA” is not a valid outline. The outline of the preset is used instead."],
		["AAAA", "o: 1 point encloses no area. The outline of the preset is used instead."],
	])("keeps the preset's and says so: %s", (text, note) => {
		const read = restore(LEAF, { v: "2", model: "leaf", o: text });
		expect(texts(read)).toEqual([note]);
		expect(read.specimen.outline).toEqual(grapevine.outline);
	});

	it("reads lists of numbers, brings them into reach and round the right way", () => {
		const clockwise = [
			[0.1, 0, 1],
			[-0.4, 0.5],
			[0, 9, "pointed"],
			[0.4, 0.5],
		];
		const read = restore(LEAF, { model: "leaf", outline: clockwise });
		expect(read.specimen.outline).toEqual([
			{ x: 0, y: 0, kind: "corner" },
			{ x: 0.4, y: 0.5, kind: "smooth" },
			{ x: 0, y: 1.547, kind: "pointed" },
			{ x: -0.4, y: 0.5, kind: "smooth" },
		]);
		expect(texts(read)).toEqual([
			"outline: Some points are too far from the petiole. The nearest allowed positions are used.",
			"outline: The first point is not at the petiole (0, 0). The first point was moved to the petiole.",
		]);
	});

	it("rejects outlines that cross themselves", () => {
		const bow = [
			[0, 0],
			[0.4, 0.8],
			[-0.1, 1],
			[0.5, 0.2],
		];
		expect(texts(restore(LEAF, { model: "leaf", outline: bow }))).toEqual([
			"outline: The outline encloses no area or crosses itself. The outline of the preset is used instead.",
		]);
	});

	it("rejects outlines without area, and ignores points beyond the limit", () => {
		const line = [0, 0.2, 0.4, 0.6].map((y) => ({ x: 0, y }));
		expect(texts(restore(LEAF, { model: "leaf", outline: line }))[0]).toContain("encloses no area");
		const many = Array.from({ length: 99 }, (_, i) => ({ x: Math.sin(i / 16) / 2, y: (1 - Math.cos(i / 16)) / 2 }));
		const read = restore(LEAF, { model: "leaf", outline: many });
		expect(read.specimen.outline).toHaveLength(64);
		expect(texts(read)[0]).toContain("more than 64 points");
	});

	it("never throws, and returns an outline that links can encode for any input", () => {
		fc.assert(
			fc.property(fc.anything(), (value) => {
				const { specimen } = restore(LEAF, { model: "leaf", outline: value, o: String(Array.isArray(value)) });
				expect(specimen.outline.length).toBeGreaterThan(2);
				expect(restore(LEAF, Object.fromEntries(new URLSearchParams(encodeQuery(LEAF, specimen)))).specimen).toEqual(
					specimen,
				);
			}),
		);
	});
});
