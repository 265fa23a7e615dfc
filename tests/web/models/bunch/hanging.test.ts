/**
 * Over many seeds: how bunches of grape presets hang, how their axes are arranged round the rachis, and where they are
 * bare.
 */

import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type BunchPlant, INTERNODE_KINDS, TRAITS } from "../../../../web/src/models/bunch/bunch_plant";
import { measureOf } from "../../../../web/src/models/bunch/measures";
import type { MEASURE_KEYS } from "../../../../web/src/models/bunch/measures.generated";
import { inRun, isLongRun } from "../../../long_run.mjs";
import { presetsInRun, specimenFromPreset } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const SEEDS = 20;
const SECTORS = 16;
/** Most bare rachis above lower berries, in berry lengths. */
const MAX_BARE = 1.5;

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const bunchesOf = (preset: string): BunchPlant[] =>
	Array.from({ length: SEEDS }, (_, seed) =>
		growBunch(core, { ...specimenFromPreset(preset), seed: seed + 1 }, { meshes: false }),
	);

const GRAPES = presetsInRun(({ kind }) => kind !== "fruit");
const coverages: number[] = [];
const spills: number[] = [];

describe.each(GRAPES)("%s", (preset) => {
	let bunches: BunchPlant[];
	beforeAll(() => {
		bunches = bunchesOf(preset);
	});

	it("hangs: at most 15 % of its berries' tips are above the horizontal", () => {
		for (const bunch of bunches) expect(upward(bunch)).toBeLessThanOrEqual(0.15);
	});

	it("has axes all round: every sixteenth holds at least 1 % of their internodes", () => {
		expect(Math.min(...shares(bunches))).toBeGreaterThanOrEqual(0.01);
	});

	it("has no tuft below bare rachis", () => {
		for (const bunch of bunches) expect(longestGap(bunch)).toBeLessThan(MAX_BARE);
	});

	it("keeps to its handles", () => {
		const of = (key: (typeof MEASURE_KEYS)[number]) => bunches.map(({ measures }) => measureOf(measures, key));
		expect(bunches[0].procedure).toBe("natural");
		expect(Math.min(...of("coverage"))).toBeGreaterThanOrEqual(0.85);
		expect(Math.max(...of("spill"))).toBeLessThanOrEqual(0.06);
		coverages.push(...of("coverage"));
		spills.push(...of("spill"));
	});
});

it.runIf(isLongRun)("keeps to the handles in the mean of presets and seeds", () => {
	expect(coverages).toHaveLength(GRAPES.length * SEEDS);
	expect(mean(coverages)).toBeGreaterThanOrEqual(0.92);
	expect(mean(spills)).toBeLessThanOrEqual(0.03);
});

it("drawn profiles have no tuft below bare rachis, loose and various ones neither", () => {
	const draws = new Draws(1);
	for (let seed = 1; seed <= inRun(20, 200); seed++) {
		const specimen = specimenFromPreset("long-conical");
		const profile: Record<string, number> = { l: draws.between(150, 580) };
		for (const side of ["p3", "p4", "p5", "p6"]) {
			profile[`${side}w`] = draws.between(30, 220);
			profile[`${side}r`] = draws.between(0, 0.7 * profile.l);
		}
		const loose = seed % 2 === 0 ? { variability: 2, density: draws.between(1, 5) } : {};
		const parameters = { ...specimen.parameters, ...profile, ...loose };
		const bunch = growBunch(core, { ...specimen, seed, parameters }, { meshes: false, measures: false });
		expect(longestGap(bunch), JSON.stringify({ seed, ...profile, ...loose })).toBeLessThan(MAX_BARE);
	}
});

const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value) / values.length;

/** Linear congruential generator (Numerical Recipes, section 7.1): the same numbers on every run. */
class Draws {
	constructor(private state: number) {}

	between(low: number, high: number): number {
		this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
		return Math.round(low + ((high - low) * this.state) / 2 ** 32);
	}
}

/**
 * Returns the longest stretch of the bunch's axis without berries beside it and with berries below, in berry lengths.
 */
function longestGap({ berries }: BunchPlant): number {
	const of = (trait: (typeof TRAITS)[number], i: number) => berries.traits[TRAITS.length * i + TRAITS.indexOf(trait)];
	const set = Array.from({ length: berries.count }, (_, i) => i).filter((i) => of("set", i) === 1);
	const mean = set.reduce((sum, i) => sum + of("length", i), 0) / set.length;
	const spans = set.map((i) => ({ middle: berries.spheres[4 * i + 1], half: of("length", i) / 2 }));
	spans.sort((a, b) => b.middle - a.middle);
	let [low, longest] = [Number.POSITIVE_INFINITY, 0];
	for (const { middle, half } of spans) {
		if (low < Number.POSITIVE_INFINITY) longest = Math.max(longest, low - (middle + half));
		low = Math.min(low, middle - half);
	}
	return longest / mean;
}

/** Returns the share of set berries that point upward. */
function upward({ berries }: BunchPlant): number {
	const set = Array.from({ length: berries.count }, (_, i) => i).filter(
		(i) => berries.traits[TRAITS.length * i + TRAITS.indexOf("set")] === 1,
	);
	return set.filter((i) => berries.directions[3 * i + 1] > 0).length / set.length;
}

/** Returns how many internodes of first-order axes lie in each sector, the first centred on +X. */
function shares(bunches: readonly BunchPlant[]): number[] {
	const counts = new Array<number>(SECTORS).fill(0);
	for (const { internodes } of bunches) {
		for (let i = 0; i < internodes.count; i++) {
			if (INTERNODE_KINDS[internodes.kind[i]] !== "axis") continue;
			const [x, , z] = [0, 1, 2].map((k) => internodes.ends[6 * i + 3 + k] - internodes.ends[6 * i + k]);
			const turn = Math.atan2(z, x) / (2 * Math.PI);
			counts[Math.floor((turn + 1 + 0.5 / SECTORS) * SECTORS) % SECTORS]++;
		}
	}
	const all = counts.reduce((sum, count) => sum + count);
	return counts.map((count) => count / all);
}
