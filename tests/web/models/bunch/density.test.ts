/** A bunch has the requested density: the parameter and the measure share the note of OIV 204. */

import fc from "fast-check";
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { MEASURE_KEYS } from "../../../../web/src/models/bunch/measures.generated";
import { inRun } from "../../../long_run.mjs";
import { presetsInRun, type Specimen, specimenFromPreset, thin, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const AGREE = 0.5;

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const grow = (specimen: Specimen) => growBunch(core, specimen, { meshes: false });
const off = (specimen: Specimen) =>
	(grow(specimen).measures?.[MEASURE_KEYS.indexOf("density")] ?? Number.NaN) - specimen.parameters.density;

const byDensity = presetsInRun()
	.map((name) => specimenFromPreset(name))
	.filter(({ parameters }) => !parameters.count);

it.each(byDensity.map((specimen) => [specimen.preset, specimen] as const))(
	"%s has the density of its parameter",
	(_, specimen) => {
		for (const seed of [1, 2, 3, 4, 5])
			expect(Math.abs(off({ ...specimen, seed })), `seed ${seed}`).toBeLessThan(AGREE);
	},
);

const width = fc.integer({ min: 50, max: 200 });
const drop = fc.integer({ min: 10, max: 200 });
const halves = (from: number, to: number) => fc.integer({ min: 2 * from, max: 2 * to }).map((twice) => twice / 2);
const profile = fc.record({
	l: fc.integer({ min: 220, max: 580 }),
	p3w: width,
	p3r: drop,
	p4w: width,
	p4r: drop,
	p5w: width,
	p5r: drop,
	p6w: width,
	p6r: drop,
	size: halves(12, 22),
	elongation: fc.integer({ min: 50, max: 70 }).map((fiftieths) => fiftieths / 50),
	pedicel: halves(4, 10),
	density: halves(2, 8),
});

it("any profile is", () => {
	const one = specimenFromPreset("long-conical");
	for (const parameters of fc.sample(profile, { numRuns: inRun(15, 50), seed: 1 }))
		expect(Math.abs(off(withParameters(one, parameters))), JSON.stringify(parameters)).toBeLessThan(AGREE);
});

it("thinning by hand and age do not change which flowers set", () => {
	const specimen = withParameters(specimenFromPreset("merlot"), { wing: 0 });
	const ids = [...grow(specimen).berries.ids];
	expect([...grow(thin(specimen, ids[3])).berries.ids]).toEqual(ids.filter((id) => id !== ids[3]));
	const young = new Set(grow(withParameters(specimen, { age: 50 })).berries.ids);
	expect(ids.filter((id) => !young.has(id))).toEqual([]);
});
