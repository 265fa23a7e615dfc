/**
 * docs/models/leaf/likeness.md: that its numbers of ours are what grows, and that they are within what it says of real leaves; and that
 * its picture is what grows. `UPDATE_LIKENESS=1 npx vitest run tests/web/models/particles/leaf/likeness` writes both anew.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import { exportJson } from "../../../../../web/src/export/json";
import type { Leaf } from "../../../../../web/src/models/particles/leaf/grown";
import { model } from "../../../../../web/src/models/particles/leaf/index";
import { leafFromPreset } from "../../../../../web/src/models/particles/leaf/species";
import { figureOf } from "./figure";

const PAGE = "docs/models/leaf/likeness.md";
const PICTURE = "docs/models/leaf/likeness.svg";
const page = readFileSync(PAGE, "utf8");

/** A row of the page's tables: | measure | ours | real | how sure | source | under a heading that names the preset. */
interface Row {
	preset: string;
	measure: string;
	ours: string;
	/** Undefined where no number was found. */
	range?: [number, number];
	line: string;
}

function rowsOf(text: string): Row[] {
	const rows: Row[] = [];
	let preset = "";
	for (const line of text.split("\n")) {
		preset = /^### .*`leaf\/([a-z-]+)`/.exec(line)?.[1] ?? preset;
		const [, measure, ours, real] = line.split("|").map((cell) => cell.trim());
		if (!preset || !measure || !(measure in MEASURED)) continue;
		const bounds = /^([\d.]+) … ([\d.]+)$/.exec(real);
		rows.push({ preset, measure, ours, range: bounds ? [Number(bounds[1]), Number(bounds[2])] : undefined, line });
	}
	return rows;
}

type Measures = Record<string, number>;

/** What the page calls it: how it is had of a leaf's measures and parameters, and with how many decimals. */
const MEASURED: Record<string, [of: (measures: Measures, parameters: Measures) => number, decimals: number]> = {
	"blade length, mm": [({ leaf_length }) => leaf_length, 0],
	"blade width, mm": [({ leaf_width }) => leaf_width, 0],
	"main vein N1, mm": [(_, { length }) => length, 0],
	"petiole, mm": [(_, { petiole, length }) => (petiole / 100) * length, 1],
	primaries: [({ count_1 }) => count_1, 0],
	"angle between primaries, °": [({ primary_angle }) => primary_angle, 0],
	"primaries together, in N1": [({ density_1, area }, { length }) => (density_1 * area * 10) / length, 1],
	"secondaries on a side": [({ count_2 }) => count_2 / 2, 1],
	"angle of secondaries, °": [({ secondary_angle }) => secondary_angle, 0],
	"spacing of secondaries, mm": [({ secondary_spacing }) => secondary_spacing, 1],
	"1° length per area, cm/cm²": [({ density_1 }) => density_1, 2],
	"2° length per area, cm/cm²": [({ density_2 }) => density_2, 2],
	"3° length per area, cm/cm²": [({ density_3 }) => density_3, 2],
};

const rows = rowsOf(page);
const presets = [...new Set(rows.map(({ preset }) => preset))];
const grown: Record<string, { leaf: Leaf; found: (measure: string) => string }> = {};

beforeAll(async () => {
	const core = await loadCoreFromBytes(readFileSync("build/core/particles.wasm"));
	for (const preset of presets) {
		const specimen = leafFromPreset(preset);
		const leaf = model.read(core.grow(model.encode(specimen, { meshes: false })));
		const { measures } = exportJson(model, leaf, specimen) as unknown as { measures: Measures };
		const found = (measure: string) => {
			const [of, decimals] = MEASURED[measure];
			return of(measures, specimen.parameters).toFixed(decimals);
		};
		grown[preset] = { leaf, found };
	}
	if (!process.env.UPDATE_LIKENESS) return;
	let text = page;
	for (const { preset, measure, ours, line } of rows)
		text = text.replace(line, line.replace(`| ${ours} |`, `| ${grown[preset].found(measure)} |`));
	writeFileSync(PAGE, text);
	writeFileSync(PICTURE, pictureOf());
});

const pictureOf = () =>
	figureOf(
		presets.map((name) => ({ name, leaf: grown[name].leaf, millimetres: leafFromPreset(name).parameters.length })),
	);

describe("the page of likenesses", () => {
	it("has four leaves, each with lengths per area, angles and spacings", () => {
		expect(presets).toHaveLength(4);
		expect(rows.length).toBeGreaterThanOrEqual(28);
		for (const order of ["1°", "2°", "3°"])
			expect(rows.filter(({ measure }) => measure.startsWith(`${order} length`))).toHaveLength(4);
		expect(rows.filter(({ range }) => range).length).toBeGreaterThanOrEqual(20);
	});

	it.each(rows)("$preset: $measure is what grows", ({ preset, measure }) => {
		const [now] = rowsOf(readFileSync(PAGE, "utf8")).filter((row) => row.preset === preset && row.measure === measure);
		expect(now.ours).toBe(grown[preset].found(measure));
	});

	it.each(rows.filter(({ range }) => range))("$preset: $measure is as of real leaves", ({ preset, measure, range }) => {
		const [least, most] = range as [number, number];
		expect(Number(grown[preset].found(measure))).toBeGreaterThanOrEqual(least);
		expect(Number(grown[preset].found(measure))).toBeLessThanOrEqual(most);
	});

	it("has a picture of what grows", () => {
		expect(readFileSync(PICTURE, "utf8") === pictureOf()).toBe(true);
	});
});
