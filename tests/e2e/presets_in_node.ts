/** Every preset as Node grows it. Loaded through Vite, which reads the app's modules as the app's bundle does. */
import { readFileSync } from "node:fs";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { encodeRequest } from "../../web/src/models/bunch/request";
import { specimenFromPreset } from "../../web/src/specimen/from_preset";
import { PRESETS } from "../../web/src/models/bunch/presets/index";

const core = await loadCoreFromBytes(readFileSync("build/core/panicle.wasm"));

export const grownInNode = PRESETS.map(({ name }) => {
	const { fingerprint, counts } = core.grow(encodeRequest(specimenFromPreset(name)));
	return { name, fingerprint, berries: counts.berries };
});
