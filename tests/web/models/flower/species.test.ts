/** Whatever seed a species is grown from, it is one of its kind: docs/models/flower/species.md has the ranges and whose they are. */
import { readFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { fetchTexts } from "../../../../web/src/models/flower/texts";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";
import { bloomWidth, organsOf } from "./organs";

const SEEDS = 8;
const PAGE = new URL("../../../../docs/models/flower/species.md", import.meta.url);

const HEIGHT = model.table.measures.findIndex(({ key }) => key === "height");

type Range = readonly [number, number];

/** What the page's table calls, and what of a text it is: millimetres and counts. */
const MEASURED: Readonly<Record<string, (plant: FlowerPlant, bearers: readonly string[]) => number[]>> = {
	height: ({ measures }) => [10 * (measures?.[HEIGHT] ?? Number.NaN)],
	flower: (plant) => [bloomWidth(plant)],
	count: (plant, bearers) => [organsOf(plant).filter(({ bearer }) => bearers.includes(bearer)).length],
	length: (plant, bearers) => organsOf(plant).flatMap((of) => (bearers.includes(of.bearer) ? [of.length] : [])),
	width: (plant, bearers) => organsOf(plant).flatMap((of) => (bearers.includes(of.bearer) ? [of.width] : [])),
};

/** `| tulip | petals on RECEPTACLE, BASE | length | 50–70 mm | … |` */
interface Row {
	preset: string;
	what: string;
	bearers: string[];
	measure: string;
	range: Range;
}

const rows: Row[] = [
	...readFileSync(PAGE, "utf8").matchAll(/^\| `([\w-]+)` \| ([^|]*) \| (\w+) \| ([\d.]+)–([\d.]+)/gm),
].map(([, preset, what, measure, low, high]) => ({
	preset,
	what,
	bearers: what.split(" on ")[1]?.split(", ") ?? [],
	measure,
	range: [Number(low), Number(high)],
}));

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
});

it("of every flower's kind some numbers are held", () => {
	const species = model.presets.list.filter(({ kind }) => kind === "species").map(({ name }) => name);
	expect([...new Set(rows.map(({ preset }) => preset))].sort()).toEqual(species.sort());
	for (const { measure } of rows) expect(Object.keys(MEASURED)).toContain(measure);
});

it.each([...new Set(rows.map(({ preset }) => preset))])("%s keeps to its ranges, and no two are alike", (preset) => {
	const alike = new Set<string>();
	for (let seed = 1; seed <= SEEDS; seed++) {
		const plant = readFlowerPlant(
			core.grow(model.encode({ ...fromPreset(model, preset), seed }, { sky: false, map: false })),
		);
		alike.add(plant.volumes.values.slice(0, 900).join());
		for (const { what, bearers, measure, range } of rows.filter((row) => row.preset === preset)) {
			const found = MEASURED[measure](plant, bearers);
			expect(found.length, `${what}, seed ${seed}`).toBeGreaterThan(0);
			expect(Math.min(...found), `${what}: ${measure}, seed ${seed}`).toBeGreaterThanOrEqual(range[0]);
			expect(Math.max(...found), `${what}: ${measure}, seed ${seed}`).toBeLessThanOrEqual(range[1]);
		}
	}
	expect(alike.size).toBe(SEEDS);
});
