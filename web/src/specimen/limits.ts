/** Ranges of what is in no parameter table. */

export const SEED = { kind: "integer", min: 0, max: 0xffffffff } as const;
/** Bytes of UTF-8 of a grammar: the core's own limit (wasm-core/src/foundation/limits.hpp). */
export const GRAMMAR_BYTES = 256 * 1024;
