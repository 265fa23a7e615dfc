/**
 * Goldens of the core: numbers and fingerprints of every preset, from the wasm. A change of any is a change of what old
 * links mean. `UPDATE_GOLDENS=1 npx vitest run tests/golden` writes them anew.
 */
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { Core } from "../../web/src/core/core";
import type { Grown } from "../../web/src/core/grown";
import { encodeRequest } from "../../web/src/core/request";
import { specimenFromPreset } from "../../web/src/specimen/from_preset";
import { PRESETS } from "../../web/src/specimen/presets";

const SEEDS = [1, 2, 4294967295];
const FINGERPRINTS_SECTION = 12;
const goldenFile = new URL("./bunch.json", import.meta.url);
const nativeGrow = new URL("../../build/asan/native_grow", import.meta.url);

const requestFor = (preset: string, seed: number) => encodeRequest({ ...specimenFromPreset(preset), seed });

function digest(grown: Grown) {
	const { internodes, berries, stem, berry, counts, fingerprint, meshFingerprint } = grown;
	const lowest = Math.min(...internodes.ends.filter((_, i) => i % 3 === 1));
	const farthest = Math.max(...berries.spheres.filter((_, i) => i % 4 === 0).map(Math.abs));
	return {
		...counts,
		depth: lowest,
		reach: farthest,
		stemVertices: stem?.internode.length,
		berryTriangles: (berry?.indices.length ?? 0) / 3,
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

describe("goldens", () => {
	const found: Record<string, ReturnType<typeof digest>> = {};
	let core: Core;

	beforeAll(async () => {
		core = await Core.instantiate(
			new WebAssembly.Module(readFileSync(new URL("../../build/core/panicle.wasm", import.meta.url))),
		);
		for (const { name } of PRESETS)
			for (const seed of SEEDS) found[`${name} ${seed}`] = digest(core.grow(requestFor(name, seed)));
		if (process.env.UPDATE_GOLDENS) writeFileSync(goldenFile, `${JSON.stringify(found, null, "\t")}\n`);
	});

	it("every preset and seed is what it was", () => {
		expect(found).toEqual(JSON.parse(readFileSync(goldenFile, "utf8")));
	});

	it("a second growth in the same instance gives the same", () => {
		for (const { name } of PRESETS) expect(digest(core.grow(requestFor(name, 1)))).toEqual(found[`${name} 1`]);
	});

	it("native and wasm agree to the bit", { timeout: 300_000 }, async () => {
		await buildCore("asan", ["native_grow"]);
		for (const { name } of PRESETS) {
			for (const seed of SEEDS) {
				const golden = found[`${name} ${seed}`];
				expect(growNatively(requestFor(name, seed)), `${name} ${seed}`).toEqual({
					fingerprint: golden?.fingerprint,
					meshFingerprint: golden?.meshFingerprint,
				});
			}
		}
	});
});
