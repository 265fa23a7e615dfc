/** How bunches of every grape preset hang, and how their axes stand round the rachis, over many seeds. */

import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type Grown, INTERNODE_KINDS, TRAITS } from "../../../../web/src/models/bunch/grown";
import { measureOf } from "../../../../web/src/models/bunch/measures";
import type { MEASURE_KEYS } from "../../../../web/src/models/bunch/measures.generated";
import { PRESETS } from "../../../../web/src/models/bunch/presets/presets";
import { specimenFromPreset } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const SEEDS = 20;
const SECTORS = 16;

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const bunchesOf = (preset: string): Grown[] =>
	Array.from({ length: SEEDS }, (_, seed) =>
		growBunch(core, { ...specimenFromPreset(preset), seed: seed + 1 }, { meshes: false }),
	);

describe.each(PRESETS.filter(({ kind }) => kind !== "fruit").map(({ name }) => name))("%s", (preset) => {
	let bunches: Grown[];
	beforeAll(() => {
		bunches = bunchesOf(preset);
	});

	it("hangs: at most 15 % of its berries' tips are above the horizontal", () => {
		for (const bunch of bunches) expect(upward(bunch)).toBeLessThanOrEqual(0.15);
	});

	it("has axes all round: every sixteenth holds at least 1 % of their internodes", () => {
		expect(Math.min(...shares(bunches))).toBeGreaterThanOrEqual(0.01);
	});

	it("keeps to its handles", () => {
		const of = (key: (typeof MEASURE_KEYS)[number]) => bunches.map(({ measures }) => measureOf(measures, key));
		expect(bunches[0].procedure).toBe("natural");
		expect(Math.min(...of("coverage"))).toBeGreaterThanOrEqual(0.85);
		expect(Math.max(...of("spill"))).toBeLessThanOrEqual(0.06);
	});
});

/** The share of berries that point upward, of those that set. */
function upward({ berries }: Grown): number {
	const set = Array.from({ length: berries.count }, (_, i) => i).filter(
		(i) => berries.traits[TRAITS.length * i + TRAITS.indexOf("set")] === 1,
	);
	return set.filter((i) => berries.directions[3 * i + 1] > 0).length / set.length;
}

/** Of the internodes of first-order axes: how many lie in each sector, the first centred on +X. */
function shares(bunches: readonly Grown[]): number[] {
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
