/** What the goldens are taken of: growths in the wasm, and the same in the native build. */
import { spawnSync } from "node:child_process";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { type Block, Columns, writeContainer } from "../../web/src/core/container";
import { PRESETS } from "../../web/src/models/bunch/presets/presets";
import { encodeRequest } from "../../web/src/models/bunch/request";
import type { BunchSpecimen } from "../../web/src/models/bunch/specimen";
import { specimenFromPreset } from "../web/bunch";

const nativeGrow = new URL("../../build/asan/native_grow", import.meta.url);

/** Builds what grows natively. */
export const buildNative = () => buildCore("asan", ["native_grow"]);

/** Everything that a growth can give. */
export const requestFor = (specimen: BunchSpecimen): Block[] => encodeRequest(specimen, { meshFingerprint: true });

/** Each procedure's presets as links mean them: of version 1 those of the paper alone. */
export const PROCEDURES = {
	paper: {
		presets: PRESETS.filter(({ kind }) => kind !== "variety"),
		specimen: (name: string) => specimenFromPreset(name, 1),
	},
	natural: { presets: PRESETS, specimen: (name: string) => specimenFromPreset(name) },
} as const;

/** What the native build gives for the same bytes. */
export function grownNatively(blocks: readonly Block[]): Columns {
	const input = writeContainer(blocks);
	const { stdout, status, stderr } = spawnSync(nativeGrow.pathname, { input, maxBuffer: 64 * 1024 * 1024 });
	if (status !== 0) throw new Error(`The native build ended with status ${status}: ${stderr}`);
	return new Columns(Uint8Array.from(stdout));
}
