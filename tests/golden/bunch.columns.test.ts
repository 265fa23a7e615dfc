/**
 * Goldens of every column that a plant has, by name, so that a change says what it changes: of some presets that between
 * them have all there is (wing, raceme, drupelets, fingers, leaves), the natural ones through their lives. Unlike
 * bunch.json these may change where what is drawn becomes better: `UPDATE_GOLDENS=1 npx vitest run tests/golden` writes
 * them anew.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../web/src/core/core";
import { fetchLeaf } from "../../web/src/models/bunch/leaf";
import type { BunchSpecimen } from "../../web/src/models/bunch/specimen";
import { freshCore } from "../web/core/wasm";
import { digest } from "./digest";
import { buildNative, grownNatively, PROCEDURES, requestFor } from "./growing";

const GOLDENS = new URL("./bunch.columns.json", import.meta.url);
const AGES = [0, 30, 60, 100, 125];

interface Subject {
	name: string;
	specimen: BunchSpecimen;
}

const paper: Subject[] = ["long-conical", "double-bunch-winged", "redcurrant"].map((preset) => ({
	name: `paper ${preset}`,
	specimen: PROCEDURES.paper.specimen(preset),
}));
const natural: Subject[] = [
	{ preset: "long-conical" },
	{ preset: "double-bunch-winged" },
	{ preset: "redcurrant" },
	{ preset: "rubus" },
	{ preset: "pizzutello" },
	{ preset: "riesling", more: { leaves: 3, cane: 1 } },
].flatMap(({ preset, more = {} }) =>
	AGES.map((age) => {
		const specimen = PROCEDURES.natural.specimen(preset);
		return {
			name: `natural ${preset} at ${age}`,
			specimen: { ...specimen, parameters: { ...specimen.parameters, ...more, age } },
		};
	}),
);
const subjects = [...paper, ...natural];

const found: Record<string, Record<string, string>> = {};

beforeAll(async () => {
	const core: Core = await freshCore();
	await fetchLeaf();
	await buildNative();
	for (const { name, specimen } of subjects) found[name] = digest(core.grow(requestFor(specimen)).columns);
	if (process.env.UPDATE_GOLDENS) writeFileSync(GOLDENS, `${JSON.stringify(found, null, "\t")}\n`);
}, 300_000);

it("have between them every column there is", () => {
	const names = new Set(Object.values(found).flatMap((columns) => Object.keys(columns)));
	for (const name of [
		"second.axes",
		"mesh.berry.positions",
		"mesh.flower.positions",
		"mesh.foliage.runs",
		"thinned.id",
	])
		expect(names).toContain(name);
});

it.each(subjects)("$name is what it was, column by column", ({ name }) => {
	expect(found[name]).toEqual(JSON.parse(readFileSync(GOLDENS, "utf8"))[name]);
});

it("native and wasm agree in every column", { timeout: 300_000 }, () => {
	for (const { name, specimen } of subjects)
		expect(digest(grownNatively(requestFor(specimen))), name).toEqual(found[name]);
});
