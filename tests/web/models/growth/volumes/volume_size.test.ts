import { expect, it } from "vitest";
import { GROWTH } from "../../../../../web/src/models/growth/schema";
import { fetchTexts } from "../../../../../web/src/models/growth/texts";
import { writtenVolumes } from "../../../../../web/src/models/growth/volumes/footprint";
import { VOLUME_SIZES, withHeight, withWidth } from "../../../../../web/src/models/growth/volumes/volume_size";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";

const [HEIGHT, WIDTH] = VOLUME_SIZES;

it("an oak has a height and a width in metres, and a change writes them into its text", async () => {
	await fetchTexts();
	const oak = fromPreset(GROWTH, "oak");
	expect([HEIGHT.read(oak, undefined), WIDTH.read(oak, undefined)]).toEqual([16, 20]);
	const { details } = HEIGHT.change(oak, 12.5, undefined);
	const smaller = { ...oak, grammar: String(details?.grammar) };
	expect([HEIGHT.read(smaller, undefined), WIDTH.read(smaller, undefined)]).toEqual([12.5, 20]);
	const narrower = { ...oak, grammar: String(WIDTH.change(smaller, 10, undefined).details?.grammar) };
	expect(writtenVolumes(narrower.grammar)).toMatchObject([{ height: 12.5, base: 6, middle: 10, top: 3 }]);
});

it("several volumes keep their proportions, and a frustum stays one", () => {
	const [low, high] = [4, 10].map((height) => ({
		...{ id: 1, base: 4, height, top: 2, middle: 3, gradient: 0, towards: 0 },
		at: [0, 0] as const,
	}));
	expect(withHeight([low, high], 20).map(({ height }) => height)).toEqual([8, 20]);
	expect(withWidth([low], 4.04)).toMatchObject([{ base: 4.04, top: 2.02, middle: 3.03 }]);
});

it("a tree without a volume written in numbers has no height before it has grown", async () => {
	await fetchTexts();
	const random = fromPreset(GROWTH, "figure-8");
	expect(HEIGHT.read(random, undefined)).toBeUndefined();
});
