/**
 * Goldens of flowers: every column of every preset, natively and as wasm. A preview: what grows may
 * change where it becomes better (`UPDATE_GOLDENS=1 npx vitest run tests/golden/flower`).
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { model } from "../../web/src/models/flower/index";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { digest } from "./digest";
import { buildNative, grownNatively } from "./growing";

const GOLDENS = new URL("./flower.columns.json", import.meta.url);
const MODULE = new URL("../../build/core/flower.wasm", import.meta.url);

const subjects = await Promise.all(
	model.presets.list.flatMap(({ name }, index) =>
		(index === 0 ? [1, 0.4] : [1]).map(async (age) => {
			const specimen = fromPreset(model, name);
			await model.prepare(specimen);
			const parameters = { ...specimen.parameters, age };
			return {
				name: `${name} at ${age}`,
				request: model.encode({ ...specimen, parameters }, { meshFingerprint: true, map: index === 0 }),
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

it("every flower is what it was, column by column", () => {
	expect(found).toEqual(JSON.parse(readFileSync(GOLDENS, "utf8")));
});

it("native and wasm agree in every column", () => {
	for (const { name, request } of subjects) expect(digest(grownNatively(request)), name).toEqual(found[name]);
});
