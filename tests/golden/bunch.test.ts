/**
 * Goldens of the core: numbers and fingerprints of every preset, from the wasm. A change of any is a change of what old
 * links mean. bunch.json has the paper's procedure, which links of version 1 mean; natural.json what grows by swelling.
 * `UPDATE_GOLDENS=1 npx vitest run tests/golden` writes natural.json anew, and nothing else writes bunch.json.
 */
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import type { Core } from "../../web/src/core/core";
import type { Grown } from "../../web/src/models/bunch/grown";
import { encodeRequest } from "../../web/src/models/bunch/request";
import { specimenFromPreset } from "../../web/src/specimen/from_preset";
import { PRESETS } from "../../web/src/models/bunch/presets/index";
import { freshCore } from "../web/core/wasm";

type Golden = ReturnType<typeof digest>;

const SEEDS = [1, 2, 4294967295];
const FINGERPRINTS_SECTION = 12;
const nativeGrow = new URL("../../build/asan/native_grow", import.meta.url);

/** Presets of the paper, as links of version 1 mean them. */
const paper = (name: string, seed: number) => encodeRequest({ ...specimenFromPreset(name, 1), seed });
const natural = (name: string, seed: number) => encodeRequest({ ...specimenFromPreset(name), seed });

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

/** The fingerprints that the native build gives for the same bytes. */
function growNatively(request: Uint8Array): { fingerprint: string; meshFingerprint: string } {
	const { stdout, status } = spawnSync(nativeGrow.pathname, { input: request, maxBuffer: 64 * 1024 * 1024 });
	expect(status).toBe(0);
	const view = new DataView(stdout.buffer, stdout.byteOffset, stdout.byteLength);
	for (let at = 0; at < view.byteLength; ) {
		const section = view.getUint32(at, true);
		const bytes = view.getUint32(at + 4, true);
		if (section === FINGERPRINTS_SECTION) {
			const word = (i: number) =>
				view
					.getUint32(at + 8 + i * 4, true)
					.toString(16)
					.padStart(8, "0");
			return { fingerprint: word(1) + word(0), meshFingerprint: word(3) + word(2) };
		}
		at += 8 + bytes;
	}
	throw new Error("The native result has no fingerprints.");
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
			for (const seed of SEEDS) found[`${name} ${seed}`] = digest(core.grow(requestFor(name, seed)));
		if (procedure === "natural" && process.env.UPDATE_GOLDENS)
			writeFileSync(goldenFile, `${JSON.stringify(found, null, "\t")}\n`);
	});

	it("every preset and seed is what it was", () => {
		expect(found).toEqual(JSON.parse(readFileSync(goldenFile, "utf8")));
	});

	it("a second growth in the same instance gives the same", () => {
		for (const { name } of presets) expect(digest(core.grow(requestFor(name, 1)))).toEqual(found[`${name} 1`]);
	});

	it("native and wasm agree to the bit", { timeout: 300_000 }, () => {
		for (const { name } of presets) {
			for (const seed of SEEDS) {
				const { fingerprint, meshFingerprint } = found[`${name} ${seed}`];
				expect(growNatively(requestFor(name, seed)), `${name} ${seed}`).toEqual({ fingerprint, meshFingerprint });
			}
		}
	});
});
