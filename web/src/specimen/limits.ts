/** Ranges of what is in no parameter table. */

export const SEED = { kind: "integer", min: 0, max: 0xffffffff } as const;
/** Bytes of UTF-8 of a grammar: the core's own limit (wasm-core/src/foundation/limits.hpp). */
export const GRAMMAR_BYTES = 256 * 1024;
/** Of a file that has a grammar as XML, which says the same at ten times the length, and rules that are short at thirty times. */
const XML_BYTES = 32 * GRAMMAR_BYTES;

/** What is wrong with so many bytes of a grammar. */
function overlong(bytes: number, most = GRAMMAR_BYTES): string | undefined {
	return bytes > most ? `longer than ${most / 1024} KiB` : undefined;
}

/** What is wrong with the length of a file that has a grammar and begins so. */
export function overlongFile(bytes: number, head: string): string | undefined {
	return overlong(bytes, /^\s*</.test(head) ? XML_BYTES : GRAMMAR_BYTES);
}

/** What is wrong with a grammar's length. */
export function overlongText(text: string): string | undefined {
	// No text has fewer bytes than units.
	return overlong(text.length) ?? overlong(new TextEncoder().encode(text).length);
}
