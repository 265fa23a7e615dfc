import { readFile } from "node:fs/promises";
import type { Core } from "../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../web/src/core/loader";
import type { BunchPlant } from "../../../web/src/models/bunch/bunch_plant";
import { readBunchPlant } from "../../../web/src/models/bunch/read_bunch_plant";
import { type BunchRequestOptions, encodeRequest } from "../../../web/src/models/bunch/request";
import type { Specimen } from "../bunch";

/** The bytes of a core as it was last built. */
export const wasmBytes = (file = "bunch.wasm") => readFile(new URL(`../../../build/core/${file}`, import.meta.url));

/** A fresh instance of it. */
export const freshCore = async (file?: string): Promise<Core> => loadCoreFromBytes(await wasmBytes(file));

/** Grows a bunch on an instance, as the page and the command do. */
export const growBunch = (core: Core, specimen: Specimen, options?: BunchRequestOptions): BunchPlant =>
	readBunchPlant(core.grow(encodeRequest(specimen, options)));
