/** The library with the tests' own cores, set up as its entry points do. */
import { CoreCache } from "../../../web/src/core/cores";
import { setRuntime } from "../../../web/src/library/runtime";
import { freshCore } from "../core/wasm";

const cores = new CoreCache(freshCore);

setRuntime({ grow: (wasm, blocks) => cores.grow(wasm, blocks) });

export * from "../../../web/src/library/index";

/** A bunch that grows in a moment. */
export const SMALL = { preset: "redcurrant", count: 5, seed: 7 };
