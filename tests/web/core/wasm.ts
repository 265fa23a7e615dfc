import { readFile } from "node:fs/promises";
import type { Core } from "../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../web/src/core/loader";

/** The bytes of the core as it was last built. */
export const wasmBytes = () => readFile(new URL("../../../build/core/panicle.wasm", import.meta.url));

/** A fresh instance of it. */
export const freshCore = async (): Promise<Core> => loadCoreFromBytes(await wasmBytes());
