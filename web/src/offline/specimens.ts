/** Answers for specimens, in the service worker: a script of its own, which is run when the first is asked for. */
import { loadCoreFromBytes } from "../core/loader";
import { makeService, type Service } from "../service/service";

/** @param bringCore a core's file, by what models call it */
export type MakeSpecimens = (bringCore: (wasm: string) => Promise<ArrayBuffer>, release: string) => Service;

const makeSpecimens: MakeSpecimens = (bringCore, release) =>
	makeService({ release, loadCore: async (wasm) => loadCoreFromBytes(await bringCore(wasm)) });

// Classic scripts have no exports.
(globalThis as { panicleSpecimens?: MakeSpecimens }).panicleSpecimens = makeSpecimens;
