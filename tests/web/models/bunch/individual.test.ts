/** Bunches of one preset vary by seed; tests their spread and that their mean is stable. */

import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import type { BunchPlant } from "../../../../web/src/models/bunch/bunch_plant";
import { measureOf } from "../../../../web/src/models/bunch/measures";
import type { MeasureKey } from "../../../../web/src/models/bunch/measures.generated";
import { entryOf, exportJson, presetsInRun, specimenFromPreset, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const SEEDS = 20;

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const bunch = (preset: string, seed: number, variability: number): BunchPlant =>
	growBunch(core, { ...withParameters(specimenFromPreset(preset), { variability }), seed }, { meshes: false });

function spread(bunches: readonly BunchPlant[], key: MeasureKey) {
	const values = bunches.map(({ measures }) => measureOf(measures, key));
	const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
	const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
	return { mean, variation: Math.sqrt(variance) / mean };
}

describe.each(presetsInRun(({ kind }) => kind !== "fruit"))("%s", (preset) => {
	let even: BunchPlant[];
	let varied: BunchPlant[];
	beforeAll(() => {
		const seeds = Array.from({ length: SEEDS }, (_, index) => index + 1);
		even = seeds.map((seed) => bunch(preset, seed, 0));
		varied = seeds.map((seed) => bunch(preset, seed, 1));
	});

	it("weighs and is as long in the mean as without variability", () => {
		// In dense bunches, narrow seeds lose more berries than wide ones gain.
		expect(Math.abs(spread(varied, "bunch_weight").mean / spread(even, "bunch_weight").mean - 1)).toBeLessThan(0.06);
		expect(Math.abs(spread(varied, "bunch_length").mean / spread(even, "bunch_length").mean - 1)).toBeLessThan(0.03);
	});

	it("varies like bunches of one variety; bunches with a fixed count vary in form only", () => {
		const counted = specimenFromPreset(preset).parameters.count > 0;
		expect(spread(even, "bunch_length").variation).toBeLessThan(0.04);
		expect(spread(varied, "bunch_length").variation).toBeGreaterThan(0.1);
		expect(spread(varied, "bunch_length").variation).toBeLessThan(0.18);
		expect(spread(varied, "bunch_weight").variation).toBeGreaterThan(counted ? 0.01 : 0.15);
		expect(spread(varied, "bunch_weight").variation).toBeLessThan(counted ? 0.08 : 0.35);
	});

	it("hangs from a peduncle of its own length, at least 25 mm", () => {
		const requested = specimenFromPreset(preset).parameters.peduncle;
		for (const { measures } of varied) {
			expect(measureOf(measures, "peduncle_length")).toBeGreaterThanOrEqual(25);
			expect(Math.abs(measureOf(measures, "peduncle_length") / requested - 1)).toBeLessThan(0.05);
		}
	});
});

it("gives the outline that it fills: the handles' without variability and for seed 1, else the seed's", () => {
	const { parameters } = specimenFromPreset("riesling");
	const profileOf = (seed: number, variability: number) => bunch("riesling", seed, variability).profile;
	expect(parameters).toMatchObject({ ...profileOf(1, 1) });
	expect(parameters).toMatchObject({ ...profileOf(4, 0) });
	expect(profileOf(4, 1)?.l).not.toBeCloseTo(parameters.l, 0);
	const varied = bunch("riesling", 4, 1);
	const specimen = { ...specimenFromPreset("riesling"), seed: 4 };
	const document = exportJson(varied, specimen) as unknown as {
		profile: Record<string, number>;
		plan: BunchPlant["plan"];
	};
	expect(document.profile.p4w).toBeCloseTo(varied.profile?.p4w ?? Number.NaN, 3);
	expect(document.plan.sides[1].w).toBe(parameters.p4w);
});

it("the paper's procedure ignores variability", () => {
	const paper = withParameters(specimenFromPreset("riesling"), { procedure: 0, variability: 1, peduncle: 80 });
	const fingerprint = (specimen: typeof paper) => growBunch(core, specimen, { meshes: false }).fingerprint;
	expect(fingerprint(paper)).toBe(fingerprint(withParameters(paper, { variability: 0, peduncle: 0, wing_side: 2 })));
	expect(growBunch(core, paper, { meshes: false }).profile).toBeUndefined();
});

it("berries vary in width as the parameter's help describes", () => {
	const stated =
		/a setting of (\d+) gives about (\d+) %, and (\d+) about (\d+) %/
			.exec(entryOf("spread")?.help ?? "")
			?.slice(1)
			.map(Number) ?? [];
	expect(stated).toHaveLength(4);
	for (const [spread, percent] of [stated.slice(0, 2), stated.slice(2)]) {
		const found = ["riesling", "merlot", "long-conical"].flatMap((preset) =>
			[1, 2, 3].map((seed) => {
				const specimen = { ...withParameters(specimenFromPreset(preset), { spread }), seed };
				return 100 * measureOf(growBunch(core, specimen, { meshes: false }).measures, "diameter_spread");
			}),
		);
		expect(Math.abs(found.reduce((sum, each) => sum + each, 0) / found.length - percent)).toBeLessThan(1.5);
		for (const each of found) expect(Math.abs(each - percent)).toBeLessThan(5);
	}
});
