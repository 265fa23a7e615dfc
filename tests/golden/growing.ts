/** Growths for the goldens: in the native build, and of bunches by both procedures. */
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { type Block, Columns, writeContainer } from "../../web/src/core/container";
import { PRESETS } from "../../web/src/models/bunch/presets/presets";
import { encodeRequest } from "../../web/src/models/bunch/request";
import type { BunchSpecimen } from "../../web/src/models/bunch/specimen";
import { specimenFromPreset } from "../web/bunch";

/** The build of the core that the wasm is compared with, and its program that grows one request. */
const PRESET = "native";
const PROGRAM = "native_grow";
const nativeGrow = fileURLToPath(new URL(`../../build/${PRESET}/${PROGRAM}`, import.meta.url));

/** Builds the native program; with `PANICLE_CORE=built` only where there is none yet. */
export async function buildNative(): Promise<void> {
	if (process.env.PANICLE_CORE === "built" && existsSync(nativeGrow)) return;
	await buildCore(PRESET, [PROGRAM]);
}

/** The answer of the native program to a request. */
export function growNatively(blocks: readonly Block[]): Columns {
	const input = writeContainer(blocks);
	const { stdout, status, stderr, error } = spawnSync(nativeGrow, { input, maxBuffer: 256 * 1024 * 1024 });
	if (status !== 0) throw new Error(`${PROGRAM} ended with status ${status}: ${error ?? stderr}`);
	return new Columns(Uint8Array.from(stdout));
}

/** A bunch's request for everything that the core can answer. */
export const requestFor = (specimen: BunchSpecimen): Block[] => encodeRequest(specimen, { meshFingerprint: true });

/** The presets of each procedure as links mean them: version 1 of links has only those of the paper. */
export const PROCEDURES = {
	paper: {
		presets: PRESETS.filter(({ kind }) => kind !== "variety"),
		specimen: (name: string) => specimenFromPreset(name, 1),
	},
	natural: { presets: PRESETS, specimen: (name: string) => specimenFromPreset(name) },
} as const;
