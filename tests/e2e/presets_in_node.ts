/** Presets as Node grows them: some in the gate, all in the long run. Loaded through Vite, which reads the app's modules as the app's bundle does. */
import { readFileSync } from "node:fs";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { PRESETS } from "../../web/src/models/bunch/presets/presets";
import { specimenFromPreset } from "../../web/src/models/bunch/schema";
import { inRun } from "../long_run.mjs";
import { growBunch } from "../web/core/wasm";

const core = await loadCoreFromBytes(readFileSync("build/core/bunch.wasm"));

const presets = PRESETS.filter((_, i) => i % inRun(8, 1) === 0);

export const grownInNode = presets.map(({ name }) => {
	const { fingerprint, counts } = growBunch(core, specimenFromPreset(name));
	return { name, fingerprint, berries: counts.berries };
});
