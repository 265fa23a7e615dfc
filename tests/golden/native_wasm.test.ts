/**
 * The core returns equal bytes for equal requests: natively and as wasm, after other requests, and in a new instance.
 * No values are recorded here: the frozen ones are in links/links.json, bunch.json and natural.json. `npm test` grows
 * a few plants of each model, `npm run test:long` every preset.
 */
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../web/src/core/core";
import { modelNamed, modelNames } from "../../web/src/models/index";
import { isLongRun } from "../long_run.mjs";
import { freshCore } from "../web/core/wasm";
import { digest } from "./digest";
import { buildNative, growNatively } from "./growing";
import { subjectsOf } from "./subjects";

const models = await Promise.all(
	modelNames().map(async (name) => {
		const model = await modelNamed(name);
		const subjects = await subjectsOf(model);
		return { name, wasm: model.wasm, subjects: subjects.filter(({ inGate }) => inGate || isLongRun) };
	}),
);

beforeAll(buildNative);

describe.each(models)("$name", ({ wasm, subjects }) => {
	const grown = new Map<string, Record<string, string>>();
	let core: Core;

	beforeAll(async () => {
		core = await freshCore(wasm);
		for (const { name, request } of subjects) grown.set(name, digest(core.grow(request).columns));
	});

	it.each(subjects)("grows the same natively and as wasm in every column: $name", ({ name, request }) => {
		expect(digest(growNatively(request))).toEqual(grown.get(name));
	});

	it("grows the same again in an instance that has grown other plants since", () => {
		for (const { name, request } of subjects.toReversed())
			expect(digest(core.grow(request).columns), name).toEqual(grown.get(name));
	});

	it("grows the same in a fresh instance", async () => {
		for (const { name, request } of subjects)
			expect(digest((await freshCore(wasm)).grow(request).columns), name).toEqual(grown.get(name));
	});

	it.runIf(isLongRun)("has every column in the plants that `npm test` grows", () => {
		// Meshes of flowers are named after their materials' numbers.
		const kindsOf = (chosen: typeof subjects) =>
			new Set(
				chosen.flatMap(({ name }) => Object.keys(grown.get(name) ?? {})).map((key) => key.replace(/\bm\d+\b/, "m#")),
			);
		expect([...kindsOf(subjects.filter(({ inGate }) => inGate))].sort()).toEqual([...kindsOf(subjects)].sort());
	});
});
