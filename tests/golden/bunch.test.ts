/**
 * Recorded counts, sizes and fingerprints of every preset of the bunch. They are frozen: a changed value changes a
 * link. bunch.json has the paper's procedure, which links of version 1 use; natural.json has the natural procedure.
 * `UPDATE_GOLDENS=1 npx vitest run tests/golden/bunch` adds new presets to natural.json and never changes recorded
 * values.
 */
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import type { Columns } from "../../web/src/core/container";
import type { Core } from "../../web/src/core/core";
import type { BunchPlant } from "../../web/src/models/bunch/bunch_plant";
import { readBunchPlant } from "../../web/src/models/bunch/read_bunch_plant";
import { readPlant } from "../../web/src/plant/read_plant";
import { inRun } from "../long_run.mjs";
import { freshCore } from "../web/core/wasm";
import { buildNative, growNatively, PROCEDURES, requestFor } from "./growing";

type Golden = ReturnType<typeof digest>;

const SEEDS = [1, 2, 4294967295];
function digest(grown: BunchPlant) {
	const { internodes, berries, stem, berry, surfaces, counts, fingerprint, meshFingerprint } = grown;
	const lowest = Math.min(...internodes.ends.filter((_, i) => i % 3 === 1));
	const farthest = Math.max(...berries.spheres.filter((_, i) => i % 4 === 0).map(Math.abs));
	return {
		...counts,
		depth: lowest,
		reach: farthest,
		stemVertices: stem?.internode.length,
		berryTriangles: ((berry ?? surfaces)?.indices.length ?? 0) / 3,
		fingerprint,
		meshFingerprint,
	};
}

/** The fingerprints, and a hash of the light at the vertices, which they do not cover. */
function printsOf(columns: Columns) {
	const { fingerprint, meshFingerprint } = readPlant({ columns, milliseconds: 0 });
	const sky = createHash("sha1").update(columns.uint8("berries.sky")).update(columns.uint8("mesh.stems.sky"));
	return { fingerprint, meshFingerprint, sky: sky.digest("hex") };
}

let core: Core;
beforeAll(async () => {
	core = await freshCore();
	await buildNative();
});

describe.each(["paper", "natural"] as const)("goldens of procedure=%s", (procedure) => {
	const { presets, specimen } = PROCEDURES[procedure];
	const request = (name: string, seed: number) => requestFor({ ...specimen(name), seed });
	const goldenFile = new URL(procedure === "paper" ? "./bunch.json" : "./natural.json", import.meta.url);
	const recorded: Record<string, Golden> = JSON.parse(readFileSync(goldenFile, "utf8"));
	const found: Record<string, Golden> = {};
	const prints: Record<string, ReturnType<typeof printsOf>> = {};

	beforeAll(() => {
		for (const { name } of presets) {
			for (const seed of SEEDS) {
				const plant = core.grow(request(name, seed));
				found[`${name} ${seed}`] = digest(readBunchPlant(plant));
				prints[`${name} ${seed}`] = printsOf(plant.columns);
			}
		}
		if (procedure === "natural" && process.env.UPDATE_GOLDENS)
			writeFileSync(goldenFile, `${JSON.stringify({ ...found, ...recorded }, null, "\t")}\n`);
	});

	it("every preset and seed grows as recorded", () => {
		expect(found).toEqual(JSON.parse(readFileSync(goldenFile, "utf8")));
	});

	it("a second growth in the same instance gives the same", () => {
		for (const { name } of presets)
			expect(digest(readBunchPlant(core.grow(request(name, 1))))).toEqual(found[`${name} 1`]);
	});

	it("native and wasm agree to the bit", () => {
		for (const { name } of presets) {
			for (const seed of inRun([SEEDS[2]], SEEDS))
				expect(printsOf(growNatively(request(name, seed))), `${name} ${seed}`).toEqual(prints[`${name} ${seed}`]);
		}
	});
});
