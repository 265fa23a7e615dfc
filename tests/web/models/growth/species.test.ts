/**
 * Laws of the species: size as described, age and season change the plant continuously, and fallen leaves lie on the
 * ground.
 */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import type { GrowthPlant } from "../../../../web/src/models/growth/growth_plant";
import { model } from "../../../../web/src/models/growth/index";
import { TRANSFORM } from "../../../../web/src/plant/part";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { namesInRun } from "../../../long_run.mjs";

const MODULE = new URL("../../../../build/core/growth.wasm", import.meta.url);
const SPECIES = model.presets.list.filter(({ kind }) => kind === "species");
const EVERGREEN = ["olive", "spruce", "pine", "stone-pine", "cypress"];

let core: Core;
beforeAll(async () => {
	core = await loadCoreFromBytes(readFileSync(MODULE));
	for (const { name } of SPECIES) await model.prepare(fromPreset(model, name));
});

function grown(name: string, parameters: Record<string, number>, measures = false): GrowthPlant {
	const preset = fromPreset(model, name);
	const specimen = { ...preset, seed: 1, parameters: { ...preset.parameters, ...parameters } };
	return model.read(core.grow(model.encode(specimen, { meshes: false, measures })), specimen);
}

const measured = ({ measures }: GrowthPlant, key: string): number =>
	measures?.[model.table.measures.findIndex((each) => each.key === key)] ?? Number.NaN;

/** Places of the organs of one tag. */
function placesOf({ organs }: GrowthPlant, tag: string): Set<string> {
	const places = new Set<string>();
	const wanted = organs.tags.indexOf(tag);
	for (let i = 0; i < organs.count; i++)
		if (organs.tag[i] === wanted) places.add(organs.transforms.subarray(TRANSFORM * i, TRANSFORM * i + 3).join(" "));
	return places;
}

const within = (some: Set<string>, all: Set<string>): boolean => [...some].every((place) => all.has(place));

/** Returns the end of each shoot. */
function tipsOf({ segments, shoots }: GrowthPlant): Map<number, Float32Array> {
	const tips = new Map<number, Float32Array>();
	for (let i = 0; i < segments.count; i++) tips.set(shoots.shoot[i], segments.ends.subarray(6 * i + 3, 6 * i + 6));
	return tips;
}

it("there are twelve species and more, of which one is a vine", () => {
	expect(SPECIES.length).toBeGreaterThanOrEqual(12);
	expect(SPECIES.map(({ name }) => name)).toContain("grapevine");
});

/** Presets of the short test run: a broad-leaved tree, an evergreen, a fruit tree and the vine. */
const GATE_SPECIES = ["oak", "pine", "apple", "grapevine"];

const speciesInRun = namesInRun(
	SPECIES.map(({ name }) => name),
	GATE_SPECIES,
);

describe.each(speciesInRun)("%s", (name) => {
	const evergreen = EVERGREEN.includes(name);

	it("has the size in its text", () => {
		const about = SPECIES.find((each) => each.name === name)?.about ?? "";
		const stated = /([\d.]+) m high(?: and|, ([\d.]+) m) wide/.exec(about);
		if (name === "grapevine") return;
		const [high, wide] = [Number(stated?.[1]), Number(stated?.[2] ?? stated?.[1])];
		const plant = grown(name, { season: 0.4 }, true);
		expect(Math.abs(measured(plant, "height") / high - 1)).toBeLessThan(0.15);
		expect(Math.abs(measured(plant, "spread") / wide - 1)).toBeLessThan(0.25);
	});

	it("grows from a seed without a jump", () => {
		const tall = measured(grown(name, { season: 0.4 }, true), "height");
		expect(grown(name, { age: 0 }).segments.count).toBe(0);
		for (const age of [4, 71]) {
			const [before, after] = [grown(name, { age }), grown(name, { age: age + 0.2 })];
			const tips = tipsOf(after);
			for (const [shoot, tip] of tipsOf(before)) {
				const now = tips.get(shoot);
				if (!now) throw new Error(`shoot ${shoot} is gone`);
				// At most the trunk's first piece, nearly all of its height, in the first of the steps.
				const moved = Math.hypot(...tip.map((value, k) => now[k] - value));
				if (moved > 0.03 * tall) expect(moved, `shoot ${shoot} at ${age}`).toBeLessThan(0.03 * tall);
			}
		}
	});

	it("goes through the year: leaves unfold, fall, and stay where they fell", () => {
		const summer = grown(name, { season: 0.4 });
		const [all, most] = [placesOf(summer, "leaf"), summer.counts.leaves];
		let lying = new Set<string>();
		for (const season of [0, 0.2, 0.6, 0.84, 1]) {
			const plant = grown(name, { season });
			expect(within(placesOf(plant, "leaf"), all), `season ${season}`).toBe(true);
			expect(plant.counts.leaves + plant.counts.shed).toBeLessThanOrEqual(most);
			// Leaves on the ground stay there.
			const shed = placesOf(plant, "shed");
			expect(within(lying, shed)).toBe(true);
			lying = shed;
			if (evergreen)
				expect([plant.counts.leaves, plant.counts.shed, plant.counts.falling, plant.fingerprint]).toEqual([
					most,
					0,
					0,
					summer.fingerprint,
				]);
		}
		if (evergreen) return;
		expect(grown(name, { season: 0 }).counts).toMatchObject({ leaves: 0, shed: 0 });
		expect(grown(name, { season: 1 }).counts).toMatchObject({ leaves: 0, shed: most });
		// Leaves that the text drops are about to fall in autumn only, and shaken off as in figure 5.
		expect(summer.counts.falling).toBe(0);
		const autumn = grown(name, { season: 0.65 }).counts;
		expect(autumn.falling).toBeGreaterThan(0.1 * autumn.leaves);
		expect(autumn.falling).toBeLessThan(0.5 * autumn.leaves);
		const shaken = grown(name, { season: 0.65, fallen: 50 });
		const fallen =
			placesOf(shaken, "fallen").size / (placesOf(shaken, "fallen").size + placesOf(shaken, "falling").size);
		expect(Math.abs(fallen - 0.5)).toBeLessThan(0.2);
		expect(within(placesOf(shaken, "falling"), all)).toBe(true);
		const falling = grown(name, { season: 0.8 }).counts;
		expect(Math.min(falling.leaves, falling.shed)).toBeGreaterThan(most / 5);
	});

	it("is in flower in spring alone, where it is a fruit tree's picture", () => {
		const flowers = (season: number) => grown(name, { season }).counts.blossoms;
		const fruit = name === "apple" || name === "cherry";
		expect(flowers(0.2) > 1000).toBe(fruit);
		expect([flowers(0), flowers(0.45), flowers(0.8)]).toEqual([0, 0, 0]);
	});
});

it("a vine has places for two bunches on each cane that is grown, above its wire, hanging down", () => {
	const { counts, organs } = grown("grapevine", {});
	// A cane of the last step has a single internode yet.
	expect(counts.bunches).toBeGreaterThan(1.5 * counts.branches);
	expect(counts.bunches).toBeLessThanOrEqual(2 * counts.branches);
	const bunch = organs.tags.indexOf("bunch");
	for (let i = 0; i < organs.count; i++) {
		if (organs.tag[i] !== bunch) continue;
		const [, y, , qx, qy, qz, qw] = organs.transforms.subarray(TRANSFORM * i, TRANSFORM * i + 7);
		expect(y).toBeGreaterThan(0.85);
		expect(organs.mesh[i]).toBe(-1);
		// Image of +Y under the rotation.
		expect(1 - 2 * (qx * qx + qz * qz)).toBeCloseTo(-1, 5);
		expect(Math.hypot(2 * (qx * qy - qz * qw), 2 * (qy * qz + qx * qw))).toBeCloseTo(0, 5);
	}
});

it("a vine’s bunches hang on its wood, to both sides of the row", () => {
	const { organs, segments } = grown("grapevine", {});
	const bunch = organs.tags.indexOf("bunch");
	const sides = [0, 0];
	for (let i = 0; i < organs.count; i++) {
		if (organs.tag[i] !== bunch) continue;
		const [x, y, z] = organs.transforms.subarray(TRANSFORM * i, TRANSFORM * i + 3);
		const ends = segments.ends.subarray(6 * organs.segment[i], 6 * organs.segment[i] + 6);
		const way = [ends[3] - ends[0], ends[4] - ends[1], ends[5] - ends[2]];
		const from = [x - ends[0], y - ends[1], z - ends[2]];
		const along = way.reduce((sum, value, k) => sum + value * from[k], 0) / Math.hypot(...way) ** 2;
		expect(along).toBeGreaterThan(-1e-3);
		expect(along).toBeLessThan(1 + 1e-3);
		expect(Math.hypot(...way.map((value, k) => from[k] - along * value))).toBeLessThan(1e-3);
		if (Math.abs(z) > 0.03) sides[z > 0 ? 1 : 0]++;
	}
	expect(Math.min(...sides)).toBeGreaterThan(5);
});

it("an oak’s leaves are as long as an oak’s, many on a twig, and all of them are counted", () => {
	const plant = grown("oak", {}, true);
	const { leaf_size: length, leaf_twig: each } = fromPreset(model, "oak").parameters;
	expect(length).toBeGreaterThanOrEqual(7);
	expect(length).toBeLessThanOrEqual(14);
	expect(plant.organs.count).toBe(2 * plant.counts.twigs);
	expect(plant.counts.leaves).toBe(each * plant.counts.twigs);
	expect(measured(plant, "leaf_count")).toBe(plant.counts.leaves);
});

/** Range of the leaf area index of crowns (Bréda 2003), and the least number of twigs' tips. */
const CROWNS: Record<string, { index: readonly [number, number]; tips: number }> = {
	oak: { index: [4, 5.5], tips: 8000 },
	beech: { index: [4, 5.5], tips: 8000 },
	lime: { index: [4, 5.5], tips: 8000 },
	birch: { index: [2.5, 4], tips: 8000 },
	willow: { index: [2.3, 4], tips: 8000 },
	apple: { index: [2.5, 4], tips: 4000 },
};

it.each(Object.entries(CROWNS))("%s has the leaf area and the twigs of a real crown", (name, { index, tips }) => {
	const plant = grown(name, { season: 0.4 }, true);
	expect(measured(plant, "leaf_index")).toBeGreaterThan(index[0]);
	expect(measured(plant, "leaf_index")).toBeLessThan(index[1]);
	expect(measured(plant, "twig_tips")).toBeGreaterThan(tips);
});

it("twigs stay in winter, without leaves", () => {
	const [summer, winter] = [grown("oak", { season: 0.4 }), grown("oak", { season: 0.05 })];
	expect(winter.counts).toMatchObject({ leaves: 0, twigs: summer.counts.twigs });
	expect(placesOf(winter, "twig")).toEqual(placesOf(summer, "twig"));
});

it("species differ at one seed, though their grammars have the same rule", () => {
	const orders = ["oak", "beech", "birch", "maple", "cherry"].map((name) => {
		const plant = grown(name, {}, true);
		return ["tips", "order2", "order3"].map((key) => measured(plant, key)).join(" ");
	});
	expect(new Set(orders).size).toBe(orders.length);
});

it("fallen leaves thin out with distance, without an edge", () => {
	const { organs, segments } = grown("oak", { season: 1 });
	const shed = organs.tags.indexOf("shed");
	const crown = Math.max(...segments.ends.filter((_, i) => i % 3 === 0).map(Math.abs));
	const rings = [0, 0, 0, 0, 0];
	for (let i = 0; i < organs.count; i++) {
		if (organs.tag[i] !== shed) continue;
		const out = Math.hypot(organs.transforms[TRANSFORM * i], organs.transforms[TRANSFORM * i + 2]) / crown;
		const ring = Math.min(4, Math.floor((out - 0.6) / 0.2));
		if (ring >= 0) rings[ring] += 1 / (0.7 + 0.2 * ring);
	}
	for (let ring = 1; ring < rings.length; ring++) expect(rings[ring]).toBeLessThan(rings[ring - 1]);
	// Some lie beyond the crown.
	expect(rings[2]).toBeGreaterThan(0.03 * rings[0]);
});
