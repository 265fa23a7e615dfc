/**
 * Flowers of a species stay within the species' ranges for every seed; docs/models/flower/species.md lists the ranges with their sources.
 * UPDATE_GOLDENS=1 writes the column *ours*.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { fetchTexts } from "../../../../web/src/models/flower/texts";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { inRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";
import { bloomWidth, type Organ, organsOf, rodsOf } from "./organs";

/** Seeds whose spread is the page's column *ours*. */
const ALL_SEEDS = 40;
const SEEDS = process.env.UPDATE_GOLDENS ? ALL_SEEDS : inRun(3, ALL_SEEDS);
const PAGE = new URL("../../../../docs/models/flower/species.md", import.meta.url);

const HEIGHT = model.table.measures.findIndex(({ key }) => key === "height");

/** Quantities of the page's table, of a plant and the organs in question: millimetres, counts, shares. */
const MEASURED: Readonly<Record<string, (plant: FlowerPlant, organs: readonly Organ[]) => number[]>> = {
	height: ({ measures }) => [10 * (measures?.[HEIGHT] ?? Number.NaN)],
	flower: (plant) => [bloomWidth(plant)],
	count: (_, organs) => [organs.length],
	length: (_, organs) => organs.map(({ length }) => length),
	width: (_, organs) => organs.map(({ width }) => width),
	longest: (_, organs) => [Math.max(...organs.map(({ length }) => length))],
	widest: (_, organs) => [Math.max(...organs.map(({ width }) => width))],
	beside: (plant, organs) => [bloomWidth(plant) / Math.max(...organs.map(({ length }) => length))],
};

/** `| tulip | petals on RECEPTACLE, BASE | length | 50–70 | 58–69 | … |` */
interface Row {
	preset: string;
	what: string;
	/** Labels that the organs grow *on*, or whose chains they are (*of*). */
	on: string[];
	of: string | undefined;
	measure: string;
	low: number;
	high: number;
	ours: string;
	line: string;
}

const rows: Row[] = [
	...readFileSync(PAGE, "utf8").matchAll(
		/^\| `([\w-]+)` \| ([^|]*) \| (\w+) \| ([\d.]+)(?:–([\d.]+))? \| ([\d.–]+) \|.*(?:\[\d|\*\*m\*\*)/gm,
	),
].map(([line, preset, what, measure, low, high = low, ours]) => ({
	line,
	preset,
	what,
	on: what.split(" on ")[1]?.split(", ") ?? [],
	of: what.split(" of ")[1],
	measure,
	low: Number(low),
	high: Number(high),
	ours,
}));

/** Cell of a row that the test writes. */
const OURS = 4;

/** Writes the range from least to greatest, as on the page. */
function spread(found: readonly number[], measure: string): string {
	const [low, high] = [Math.min(...found), Math.max(...found)].map((each) =>
		measure === "beside"
			? each.toFixed(2)
			: each < 10 && measure !== "count"
				? each.toFixed(1)
				: String(Math.round(each)),
	);
	return low === high ? low : `${low}–${high}`;
}

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
});

it("of every flower's kind some numbers are held, each with its source", () => {
	const species = model.presets.list.filter(({ kind }) => kind === "species").map(({ name }) => name);
	expect([...new Set(rows.map(({ preset }) => preset))].sort()).toEqual(species.sort());
	expect(rows).toHaveLength([...readFileSync(PAGE, "utf8").matchAll(/^\| `[\w-]+` \|/gm)].length);
	for (const { measure } of rows) expect(Object.keys(MEASURED)).toContain(measure);
});

it.each([...new Set(rows.map(({ preset }) => preset))])("%s keeps to its ranges, and no two are alike", (preset) => {
	const alike = new Set<string>();
	const mine = rows.filter((row) => row.preset === preset).map((row) => ({ ...row, all: [] as number[] }));
	for (let seed = 1; seed <= SEEDS; seed++) {
		const plant = readFlowerPlant(
			core.grow(model.encode({ ...fromPreset(model, preset), seed }, { sky: false, map: false })),
		);
		alike.add(plant.volumes.values.slice(0, 900).join());
		const organs = organsOf(plant);
		for (const { what, on, of, measure, low, high, all } of mine) {
			const meant = of ? rodsOf(plant, of) : organs.filter(({ parentLabel }) => on.includes(parentLabel));
			const found = MEASURED[measure](plant, meant);
			expect(found.length, `${what}, seed ${seed}`).toBeGreaterThan(0);
			expect(Math.min(...found), `${what}: ${measure}, seed ${seed}`).toBeGreaterThanOrEqual(low);
			expect(Math.max(...found), `${what}: ${measure}, seed ${seed}`).toBeLessThanOrEqual(high);
			all.push(...found);
		}
	}
	expect(alike.size).toBe(SEEDS);
	if (process.env.UPDATE_GOLDENS) {
		let page = readFileSync(PAGE, "utf8");
		for (const { line, all, measure } of mine) {
			const cells = line.split(" | ");
			cells[OURS] = spread(all, measure);
			page = page.replace(line, () => cells.join(" | "));
		}
		writeFileSync(PAGE, page);
		return;
	}
	const named = ({ what, measure }: Row, ours: string) => `${what}: ${measure} ${ours}`;
	const found = mine.map((row) => named(row, spread(row.all, row.measure)));
	if (SEEDS === ALL_SEEDS) expect(mine.map((row) => named(row, row.ours))).toEqual(found);
	// Fewer seeds spread no further.
	for (const { what, measure, ours, all } of mine) {
		const [least, most = least] = ours.split("–").map(Number);
		const [low, high = low] = spread(all, measure).split("–").map(Number);
		expect(low, `${what}: ${measure}`).toBeGreaterThanOrEqual(least);
		expect(high, `${what}: ${measure}`).toBeLessThanOrEqual(most);
	}
});
