/**
 * Goldens of growth grammars' trees: every column of every preset after six steps, natively and as wasm. A preview: what grows may
 * change where it becomes better (`UPDATE_GOLDENS=1 npx vitest run tests/golden/growth`).
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { model } from "../../web/src/models/growth/index";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { digest } from "./digest";
import { buildNative, grownNatively } from "./growing";

const GOLDENS = new URL("./growth.columns.json", import.meta.url);
const MODULE = new URL("../../build/core/growth.wasm", import.meta.url);
const STEPS = 6;

const subjects = await Promise.all(
	model.presets.list.flatMap(({ name }, index) =>
		(index === 0 ? [100, 70] : [100]).map(async (age) => {
			const specimen = fromPreset(model, name);
			await model.prepare(specimen);
			const parameters = { ...specimen.parameters, steps: STEPS, age };
			return {
				name: `${name} at ${age}`,
				request: model.encode({ ...specimen, parameters }, { meshFingerprint: true }),
			};
		}),
	),
);

const found: Record<string, Record<string, string>> = {};

beforeAll(async () => {
	const core = await loadCoreFromBytes(readFileSync(MODULE));
	await buildNative();
	for (const { name, request } of subjects) found[name] = digest(core.grow(request).columns);
	if (process.env.UPDATE_GOLDENS) writeFileSync(GOLDENS, `${JSON.stringify(found, null, "\t")}\n`);
}, 300_000);

it("every tree is what it was, column by column", () => {
	expect(found).toEqual(JSON.parse(readFileSync(GOLDENS, "utf8")));
});

it("native and wasm agree in every column", () => {
	for (const { name, request } of subjects) expect(digest(grownNatively(request)), name).toEqual(found[name]);
});
