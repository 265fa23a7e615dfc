/** Limits of values that no parameter table lists. */

export const SEED = { kind: "integer", min: 0, max: 0xffffffff } as const;
/** The most bytes of UTF-8 of a grammar: the core's own limit (wasm-core/src/foundation/limits.hpp). */
export const GRAMMAR_BYTES = 256 * 1024;
/** The most bytes of a file with a grammar as XML, which is ten times as long, thirty times with short rules. */
const XML_BYTES = 32 * GRAMMAR_BYTES;

/** The problem with this many bytes of a grammar, if any. */
function lengthProblem(bytes: number, most = GRAMMAR_BYTES): string | undefined {
	return bytes > most ? `longer than ${most / 1024} KiB` : undefined;
}

/** The problem with the length of a grammar's file that begins with `head`, if any. */
export function fileLengthProblem(bytes: number, head: string): string | undefined {
	return lengthProblem(bytes, /^\s*</.test(head) ? XML_BYTES : GRAMMAR_BYTES);
}

/** The problem with a grammar's length, if any. */
export function textLengthProblem(text: string): string | undefined {
	// A text has at least as many bytes as UTF-16 code units.
	return lengthProblem(text.length) ?? lengthProblem(new TextEncoder().encode(text).length);
}
