/** Named varieties come out with the counts and weights of docs/varieties.md: the mean of a few seeds. */

import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { MEASURE_KEYS, type MeasureKey } from "../../../../web/src/models/bunch/measures.generated";
import { PRESETS } from "../../../../web/src/models/bunch/presets/presets";
import { specimenFromPreset, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

type Range = [least: number, most: number];

/** Berries, bunch weight in g, weight of a berry in g, bunch length in mm. */
const KNOWN: Record<string, { berries: Range; weight: Range; berry: Range; length: Range }> = {
	"pinot-noir": { berries: [74, 144], weight: [66, 140], berry: [1.0, 1.6], length: [100, 150] },
	riesling: { berries: [85, 130], weight: [80, 160], berry: [1.1, 1.4], length: [80, 140] },
	gewurztraminer: { berries: [60, 110], weight: [75, 120], berry: [0.9, 1.5], length: [80, 120] },
	"cabernet-sauvignon": { berries: [75, 150], weight: [73, 170], berry: [0.8, 1.3], length: [120, 150] },
	merlot: { berries: [90, 150], weight: [113, 165], berry: [1.0, 1.4], length: [120, 170] },
	chardonnay: { berries: [76, 130], weight: [90, 160], berry: [0.94, 1.6], length: [100, 135] },
	tempranillo: { berries: [120, 200], weight: [250, 400], berry: [1.7, 2.4], length: [160, 220] },
	syrah: { berries: [80, 150], weight: [115, 200], berry: [0.9, 2.0], length: [130, 190] },
	concord: { berries: [25, 50], weight: [80, 150], berry: [2.5, 4.0], length: [90, 140] },
	"muscat-of-alexandria": { berries: [60, 100], weight: [300, 430], berry: [4.0, 5.2], length: [170, 230] },
	"thompson-seedless": { berries: [110, 180], weight: [350, 480], berry: [2.2, 4.0], length: [170, 240] },
	"crimson-seedless": { berries: [100, 160], weight: [550, 720], berry: [4.4, 5.6], length: [190, 250] },
	"red-globe": { berries: [50, 90], weight: [600, 900], berry: [8.0, 13.0], length: [200, 250] },
	kyoho: { berries: [30, 35], weight: [380, 460], berry: [11.0, 13.0], length: [140, 190] },
	"shine-muscat": { berries: [40, 50], weight: [480, 700], berry: [10.0, 16.0], length: [140, 200] },
	pizzutello: { berries: [50, 90], weight: [300, 430], berry: [4.6, 6.2], length: [150, 220] },
};
const SEEDS = [1, 2, 3];

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

it("every variety is looked after", () => {
	const varieties = PRESETS.filter(({ kind }) => kind === "variety").map(({ name }) => name);
	expect(Object.keys(KNOWN).sort()).toEqual(varieties.sort());
});

it.each(Object.entries(KNOWN))("%s has the documented weight and count", (name, known) => {
	const even = withParameters(specimenFromPreset(name), { variability: 0 });
	const bunches = SEEDS.map((seed) => growBunch(core, { ...even, seed }, { meshes: false }));
	const mean = (key: MeasureKey) => {
		const sum = bunches.reduce(
			(total, { measures }) => total + (measures?.[MEASURE_KEYS.indexOf(key)] ?? Number.NaN),
			0,
		);
		return sum / bunches.length;
	};
	const within = (key: MeasureKey, [least, most]: Range) => {
		expect(mean(key), key).toBeGreaterThanOrEqual(least);
		expect(mean(key), key).toBeLessThanOrEqual(most);
	};
	within("berry_count", known.berries);
	within("bunch_weight", known.weight);
	within("berry_weight", known.berry);
	within("bunch_length", known.length);
});
