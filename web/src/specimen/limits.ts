/** Ranges of what is not in the parameter table. */

/** Bytes of UTF-8 of a grammar: the core's own limit (wasm-core/src/foundation/limits.hpp). */
export const GRAMMAR_BYTES = 256 * 1024;

export const SEED = { kind: "integer", min: 0, max: 0xffffffff } as const;

/** The grammar's own inputs: rachis segments, and segments of each first-order axis. */
export const INPUT_M = { kind: "integer", min: 1, max: 100 } as const;
export const INPUT_N = { kind: "integer", min: 0, max: 100 } as const;
/** Values of `n`: n₁ … n₍m−1₎ of the longest rachis. */
export const INPUT_N_LENGTH = INPUT_M.max - 1;

/** Ids of berries are below this (boundary/panicle.h). */
export const BERRY_IDS = 2 ** 30;
/** Berries that can be taken off by hand: a link of as many still fits an address bar. */
export const MOST_THINNED = 500;
