/**
 * Goldens of the core: numbers and fingerprints of every preset, from the wasm. A change of any is a change of what old
 * links mean. bunch.json has the paper's procedure, which links of version 1 mean; natural.json what grows by swelling.
 * `UPDATE_GOLDENS=1 npx vitest run tests/golden` writes natural.json anew, and nothing else writes bunch.json.
 */

import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { type Block, Columns, writeContainer } from "../../web/src/core/container";
import type { Core } from "../../web/src/core/core";
import type { Grown } from "../../web/src/models/bunch/grown";
import { PRESETS } from "../../web/src/models/bunch/presets/index";
import { readGrown } from "../../web/src/models/bunch/read_grown";
import { encodeRequest } from "../../web/src/models/bunch/request";
import { readPlant } from "../../web/src/plant/read_plant";
import { specimenFromPreset } from "../web/bunch";
import { freshCore } from "../web/core/wasm";

type Golden = ReturnType<typeof digest>;

const SEEDS = [1, 2, 4294967295];
const nativeGrow = new URL("../../build/asan/native_grow", import.meta.url);

/** Everything that a digest has in it. */
const WHOLE = { meshFingerprint: true };
/** Presets of the paper, as links of version 1 mean them. */
const paper = (name: string, seed: number) => encodeRequest({ ...specimenFromPreset(name, 1), seed }, WHOLE);
const natural = (name: string, seed: number) => encodeRequest({ ...specimenFromPreset(name), seed }, WHOLE);

function digest(grown: Grown) {
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

/** What has to agree to the bit, the sky of the vertices with it: fingerprints are without. */
function printsOf(columns: Columns) {
	const { fingerprint, meshFingerprint } = readPlant({ columns, milliseconds: 0 });
	const sky = createHash("sha1").update(columns.octets("berries.sky")).update(columns.octets("mesh.stems.sky"));
	return { fingerprint, meshFingerprint, sky: sky.digest("hex") };
}

/** The answer of the native build to the same bytes. */
function growNatively(blocks: readonly Block[]): Columns {
	const input = writeContainer(blocks);
	const { stdout, status } = spawnSync(nativeGrow.pathname, { input, maxBuffer: 64 * 1024 * 1024 });
	expect(status).toBe(0);
	return new Columns(Uint8Array.from(stdout));
}

let core: Core;
beforeAll(async () => {
	core = await freshCore();
	await buildCore("asan", ["native_grow"]);
}, 300_000);

describe.each([
	{ procedure: "paper", requestFor: paper, presets: PRESETS.filter(({ kind }) => kind !== "variety") },
	{ procedure: "natural", requestFor: natural, presets: PRESETS },
])("goldens of procedure=$procedure", ({ procedure, requestFor, presets }) => {
	const goldenFile = new URL(procedure === "paper" ? "./bunch.json" : "./natural.json", import.meta.url);
	const found: Record<string, Golden> = {};

	beforeAll(() => {
		for (const { name } of presets)
			for (const seed of SEEDS) found[`${name} ${seed}`] = digest(readGrown(core.grow(requestFor(name, seed))));
		if (procedure === "natural" && process.env.UPDATE_GOLDENS)
			writeFileSync(goldenFile, `${JSON.stringify(found, null, "\t")}\n`);
	});

	it("every preset and seed is what it was", () => {
		expect(found).toEqual(JSON.parse(readFileSync(goldenFile, "utf8")));
	});

	it("a second growth in the same instance gives the same", () => {
		for (const { name } of presets)
			expect(digest(readGrown(core.grow(requestFor(name, 1))))).toEqual(found[`${name} 1`]);
	});

	it("native and wasm agree to the bit", { timeout: 300_000 }, () => {
		for (const { name } of presets) {
			for (const seed of SEEDS) {
				const request = requestFor(name, seed);
				const { columns } = core.grow(request);
				expect(printsOf(growNatively(request)), `${name} ${seed}`).toEqual(printsOf(columns));
			}
		}
	});
});
