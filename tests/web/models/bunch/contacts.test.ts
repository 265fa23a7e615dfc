/** How deeply berries press on each other in bunches of every grape preset. */

import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type BunchPlant, TRAITS } from "../../../../web/src/models/bunch/bunch_plant";
import { PRESETS } from "../../../../web/src/models/bunch/presets/presets";
import { inRun } from "../../../long_run.mjs";
import { specimenFromPreset } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const SEEDS = inRun([1], [1, 2, 3]);

/**
 * Share of the smaller berry's half width from which on an overlap is deep: its facet is then as wide as two thirds of
 * the berry.
 */
const DEEP = 0.5;

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

it("deep contacts are less than a third of all, and about one for two berries", () => {
	let [deep, contacts, berries] = [0, 0, 0];
	for (const { name } of PRESETS.filter(({ kind }) => kind !== "fruit")) {
		for (const seed of SEEDS) {
			const bunch = growBunch(core, { ...specimenFromPreset(name), seed }, { meshes: false });
			const overlaps = overlapsOf(bunch);
			deep += overlaps.filter((overlap) => overlap > DEEP).length;
			contacts += overlaps.length;
			berries += bunch.berries.count;
		}
	}
	expect(contacts).toBeGreaterThan(berries);
	expect(deep / contacts).toBeLessThan(0.31);
	expect(deep / berries).toBeLessThan(0.53);
});

interface Capsule {
	centre: number[];
	direction: number[];
	/** Radius of the swept ball, and its travel from the centre to either side. */
	ball: number;
	core: number;
}

const dot = (a: number[], b: number[]) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const clamp = (x: number, most: number) => Math.min(most, Math.max(-most, x));

/** Returns for each touching pair the overlap as a share of the smaller berry's half width. */
function overlapsOf(bunch: BunchPlant): number[] {
	const all = capsulesOf(bunch);
	return all.flatMap((a, i) => all.slice(i + 1).map((b) => overlap(a, b))).filter((share) => share > 0);
}

function overlap(a: Capsule, b: Capsule): number {
	const between = a.centre.map((x, k) => b.centre[k] - x);
	const reach = a.ball + b.ball;
	if (Math.sqrt(dot(between, between)) > reach + a.core + b.core) return 0;
	const [along, da, db] = [dot(a.direction, b.direction), dot(a.direction, between), dot(b.direction, between)];
	const crossing = 1 - along * along;
	const t = clamp(along * (crossing > 1e-5 ? clamp((da - along * db) / crossing, a.core) : 0) - db, b.core);
	const s = clamp(along * t + da, a.core);
	const way = between.map((x, k) => x + b.direction[k] * t - a.direction[k] * s);
	return (reach - Math.sqrt(dot(way, way))) / Math.min(a.ball, b.ball);
}

/** Returns the berries that set, as for contacts: those longer than wide are balls swept along their cores. */
function capsulesOf({ berries }: BunchPlant): Capsule[] {
	const of = (trait: (typeof TRAITS)[number], i: number) => berries.traits[TRAITS.length * i + TRAITS.indexOf(trait)];
	return Array.from({ length: berries.count }, (_, i) => i)
		.filter((i) => of("set", i) === 1)
		.map((i) => {
			const [a, b] = [of("width", i) / 2, of("length", i) / 2];
			return {
				centre: [...berries.spheres.subarray(4 * i, 4 * i + 3)],
				direction: [...berries.directions.subarray(3 * i, 3 * i + 3)],
				ball: b >= a ? a : (2 * a + b) / 3,
				core: Math.max(0, b - a),
			};
		});
}
