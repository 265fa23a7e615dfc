/** Limits of values that no parameter table lists. */
import type { Message } from "../locale/texts";
import { text } from "./messages.generated";

export const SEED = { kind: "integer", min: 0, max: 0xffffffff } as const;
/** The most bytes of UTF-8 of a grammar: the core's own limit (wasm-core/src/foundation/limits.hpp). */
export const GRAMMAR_BYTES = 256 * 1024;
/** The most bytes of a file with a grammar as XML, which is ten times as long, thirty times with short rules. */
const XML_BYTES = 32 * GRAMMAR_BYTES;

/** Returns the problem of a text with this many bytes; undefined if it is not too long. */
function lengthProblem(bytes: number, most = GRAMMAR_BYTES): Message | undefined {
	return bytes > most ? text.message("text_too_long", { most: most / 1024 }) : undefined;
}

/**
 * Returns the problem with the length of a grammar's file; undefined if there is none.
 * @param head the beginning of the file: XML, which begins with `<`, may be longer
 */
export function fileLengthProblem(bytes: number, head: string): Message | undefined {
	return lengthProblem(bytes, /^\s*</.test(head) ? XML_BYTES : GRAMMAR_BYTES);
}

/** Returns the problem with a grammar's length; undefined if there is none. */
export function textLengthProblem(grammar: string): Message | undefined {
	// A text has at least as many bytes as UTF-16 code units.
	return lengthProblem(grammar.length) ?? lengthProblem(new TextEncoder().encode(grammar).length);
}
