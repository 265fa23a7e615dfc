/** The flower language for the editor (docs/models/flower/language.md). */

import type { Dialect } from "../../../grammar_editor/dialect";
import type { Token, TokenKind } from "../../../grammar_editor/scan";
import { text as message } from "../messages.generated";

const PIECE =
	/\/\*[\s\S]*?(?:\*\/|$)|@[^@]*@?|\n|[ \t\r\f\v]+|-->|->|→|"[^"\n]*"?|#[ \t]*\p{L}+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\.\p{L}+)?|[<>=!]=|&&|\|\||[\s\S]/gu;

/**
 * Classifies a piece of text for colouring.
 * @param rest the text behind the piece: an opening parenthesis makes a name a function
 */
function kindOf(piece: string, rest: string): TokenKind {
	if (piece.startsWith("/*") || piece.startsWith("@")) return "comment";
	if (piece.startsWith("#")) return "statement";
	if (/^(?:-->|->|→)$/.test(piece)) return "arrow";
	if (/^[\d.]/.test(piece) && piece !== ".") return "number";
	if (piece.startsWith('"')) return "symbol";
	if (/^\p{L}/u.test(piece)) return /^[ \t]*\(/.test(rest) ? "function" : "name";
	return /^(?:[<>=!]=|&&|\|\||[-+*/%^!<>=|])$/.test(piece) ? "operator" : "mark";
}

/** Splits a text into tokens, without blanks. */
export function scan(text: string): Token[] {
	const pieces: Token[] = [];
	let line = 1;
	for (const match of text.matchAll(PIECE)) {
		const [piece] = match;
		const to = match.index + piece.length;
		if (!/^[ \t\r\f\v\n]/.test(piece))
			pieces.push({ kind: kindOf(piece, text.slice(to, to + 8)), from: match.index, to, text: piece, line });
		line += piece.split("\n").length - 1;
	}
	return pieces;
}

/**
 * Describes a statement of the language for completion and help.
 * @param written an example of it
 */
const statementWord = (name: string, written: string, help: string) => ({
	kind: "statement" as const,
	name,
	written,
	help,
});
/** Describes another word of the language for completion and help. */
const otherWord = (name: string, help: string, written = name) => ({ kind: "function" as const, name, written, help });

export const FLOWER_LANGUAGE: Dialect = {
	scan,
	/** Statements and words with their explanations, for completion and for the word at the cursor. */
	get words() {
		return [
			statementWord("-->", "A{before}{condition}{after} -> A[B(…)]_{E}", message("help_rule")),
			statementWord("#define", "#define STEM(N, atx, aty, atz, H, L, W, m)", message("help_define")),
			statementWord("#axiom", "#axiom: STEM", message("help_axiom")),
			statementWord("#module", "#module PETAL", message("help_module")),
			statementWord("#material", '#material 4 petal "c8102e" "f6d55c" veins "8a1030" 9 0.5', message("help_material")),
			otherWord("step", message("help_step")),
			otherWord("finalStep", message("help_final_step")),
			otherWord("age", message("help_age")),
			otherWord("face", message("help_face")),
			otherWord("along", message("help_along")),
			otherWord("beside", message("help_beside")),
			otherWord("math.random", message("help_random"), "math.random(from, to)"),
		];
	},
};
