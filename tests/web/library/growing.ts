/** The library on cores of the tests' own, as its front doors lay them. */
import { Cores } from "../../../web/src/core/cores";
import { layGround } from "../../../web/src/library/ground";
import { freshCore } from "../core/wasm";

const cores = new Cores(freshCore);

layGround({ grow: (wasm, blocks) => cores.grow(wasm, blocks) });

export * from "../../../web/src/library/index";

/** A bunch that grows in a moment. */
export const SMALL = { preset: "redcurrant", count: 5, seed: 7 };
