/**
 * Goldens of stands: every column of every preset's plan, natively and as wasm. A preview: what is laid may change where it becomes
 * better (`UPDATE_GOLDENS=1 npx vitest run tests/golden/stand`).
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { model } from "../../web/src/models/stand/index";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { digest } from "./digest";
import { buildNative, grownNatively } from "./growing";

const GOLDENS = new URL("./stand.columns.json", import.meta.url);
const MODULE = new URL("../../build/core/stand.wasm", import.meta.url);

const subjects = await Promise.all(
	model.presets.list.map(async ({ name }) => {
		const specimen = fromPreset(model, name);
		await model.prepare(specimen);
		return { name, request: model.encode(specimen) };
	}),
);

const found: Record<string, Record<string, string>> = {};

beforeAll(async () => {
	const core = await loadCoreFromBytes(readFileSync(MODULE));
	await buildNative();
	for (const { name, request } of subjects) found[name] = digest(core.grow(request).columns);
	if (process.env.UPDATE_GOLDENS) writeFileSync(GOLDENS, `${JSON.stringify(found, null, "\t")}\n`);
}, 300_000);

it("every stand is laid as it was, column by column", () => {
	expect(found).toEqual(JSON.parse(readFileSync(GOLDENS, "utf8")));
});

it("native and wasm agree in every column", () => {
	for (const { name, request } of subjects) expect(digest(grownNatively(request)), name).toEqual(found[name]);
});
