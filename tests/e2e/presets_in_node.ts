/** Every preset as Node grows it. Loaded through Vite, which reads the app's modules as the app's bundle does. */
import { readFileSync } from "node:fs";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { PRESETS } from "../../web/src/models/bunch/presets/presets";
import { specimenFromPreset } from "../../web/src/models/bunch/species";
import { growBunch } from "../web/core/wasm";

const core = await loadCoreFromBytes(readFileSync("build/core/bunch.wasm"));

export const grownInNode = PRESETS.map(({ name }) => {
	const { fingerprint, counts } = growBunch(core, specimenFromPreset(name));
	return { name, fingerprint, berries: counts.berries };
});
