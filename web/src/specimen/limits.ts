/** Ranges of what is in no parameter table. */

export const SEED = { kind: "integer", min: 0, max: 0xffffffff } as const;
/** Bytes of UTF-8 of a grammar: the core's own limit (wasm-core/src/foundation/limits.hpp). */
export const GRAMMAR_BYTES = 256 * 1024;
/** Of a file that has a grammar as XML, which says the same at some ten times the length. */
const XML_BYTES = 16 * GRAMMAR_BYTES;

/** What is wrong with a file's length, for a grammar that begins so. */
export function overlong(bytes: number, head: string): string | undefined {
	const most = /^\s*</.test(head) ? XML_BYTES : GRAMMAR_BYTES;
	return bytes > most ? `longer than ${most / 1024} KiB` : undefined;
}
