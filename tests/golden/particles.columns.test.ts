/**
 * Goldens of leaf, tree and root: every column of every preset, of fewer particles that they take no longer, and of one
 * of each half-way. They are previews: these may change where what grows becomes better (`UPDATE_GOLDENS=1 npx vitest run
 * tests/golden`).
 */
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, expect, it } from "vitest";
import type { Block } from "../../web/src/core/container";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import type { Model } from "../../web/src/models/model";
import { model as leaf } from "../../web/src/models/particles/leaf/index";
import { model as root } from "../../web/src/models/particles/root/index";
import { model as tree } from "../../web/src/models/particles/tree/index";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { digest } from "./digest";
import { buildNative, grownNatively } from "./growing";

const GOLDENS = new URL("./particles.columns.json", import.meta.url);
const MODULE = new URL("../../build/core/particles.wasm", import.meta.url);
const PARTICLES = 400;

async function requestOf(model: Model, preset: string, age: number): Promise<Block[]> {
	const specimen = fromPreset(model, preset);
	await model.prepare?.(specimen);
	const parameters = { ...specimen.parameters, particles: PARTICLES, age };
	return model.encode({ ...specimen, parameters });
}

const subjects = await Promise.all(
	([leaf, tree, root] as unknown as Model[]).flatMap((model) =>
		model.presets.list.flatMap(({ name }, index) =>
			(index === 0 ? [100, 45] : [100]).map(async (age) => ({
				name: `${model.name} ${name} at ${age}`,
				request: await requestOf(model, name, age),
			})),
		),
	),
);

const found: Record<string, Record<string, string>> = {};

beforeAll(async () => {
	const core = await loadCoreFromBytes(readFileSync(MODULE));
	await buildNative();
	for (const { name, request } of subjects) found[name] = digest(core.grow(request).columns);
	if (process.env.UPDATE_GOLDENS) writeFileSync(GOLDENS, `${JSON.stringify(found, null, "\t")}\n`);
}, 300_000);

it.each(subjects)("$name is what it was, column by column", ({ name }) => {
	expect(found[name]).toEqual(JSON.parse(readFileSync(GOLDENS, "utf8"))[name]);
});

it("native and wasm agree in every column", { timeout: 300_000 }, () => {
	for (const { name, request } of subjects) expect(digest(grownNatively(request)), name).toEqual(found[name]);
});
