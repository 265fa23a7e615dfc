/** The growth language for the editor (docs/models/growth/language.md). */

import type { Dialect } from "../../../grammar_editor/dialect";
import type { Token, TokenKind } from "../../../grammar_editor/scan";
import { text as message } from "../messages.generated";

const PIECE =
	/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|-->|->|→|"[^"\n]*"?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\.\p{L}+)?|[<>=!]=|&&|\|\||[\s\S]/gu;
const STATEMENTS = new Set(["footprint", "tree", "gs", "bud"]);

/**
 * Classifies a piece of text for colouring.
 * @param fresh whether it begins a statement
 * @param rest the text behind the piece: an opening parenthesis makes it a function
 */
function kindOf(piece: string, fresh: boolean, rest: string): TokenKind {
	if (piece.startsWith("/*")) return "comment";
	if (/^(?:-->|->|→)$/.test(piece)) return "arrow";
	if (/^[\d.]/.test(piece) && piece !== ".") return "number";
	if (piece.startsWith('"')) return "symbol";
	if (/^\p{L}/u.test(piece)) {
		if (fresh && STATEMENTS.has(piece.split(".")[0])) return "statement";
		return /^[ \t]*\(/.test(rest) ? "function" : "name";
	}
	return /^(?:[<>=!]=|&&|\|\||[-+*/%^!<>=])$/.test(piece) ? "operator" : "mark";
}

/** Splits a text into tokens, without blanks. */
function scan(text: string): Token[] {
	const pieces: Token[] = [];
	let line = 1;
	let fresh = true;
	for (const match of text.matchAll(PIECE)) {
		const [piece] = match;
		if (piece === "\n") {
			line++;
			fresh = true;
			continue;
		}
		if (/^[ \t\r\f\v]/.test(piece)) continue;
		const to = match.index + piece.length;
		const kind = kindOf(piece, fresh, text.slice(to, to + 8));
		pieces.push({ kind, from: match.index, to, text: piece, line });
		line += piece.split("\n").length - 1;
		if (kind !== "comment") fresh = false;
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

export const GROWTH_LANGUAGE: Dialect = {
	scan,
	/** Statements and words with their explanations, for completion and for the word at the cursor. */
	get words() {
		return [
			statementWord("-->", "condition -> successor : probability", message("help_rule")),
			statementWord("gs", "gs = 8", message("help_gs")),
			statementWord("footprint", "footprint -> GrowVol(…)", message("help_footprint")),
			statementWord("tree", 'tree -> DivFunc("sigma1"){branches}', message("help_tree")),
			statementWord("bud", "bud(k - 1) : condition -> branch : 0.9", message("help_bud")),
			otherWord("GrowVol", message("help_growvol"), "GrowVol(cnt, id, wb, h, wt, grad)"),
			otherWord("DivFunc", message("help_divfunc"), "DivFunc(type, …){branches}"),
			otherWord("k", message("help_k")),
			otherWord("N", message("help_n")),
			otherWord("ndv", message("help_ndv")),
			otherWord("nbr", message("help_nbr")),
			otherWord("nlf", message("help_nlf")),
			otherWord("D", message("help_d"), "D(k)"),
			otherWord("E", message("help_e"), "E(k)"),
			otherWord("leaf", message("help_leaf"), "leaf(n)"),
			otherWord("fallingLeaf", message("help_falling"), "fallingLeaf(n)"),
			otherWord("childTrunk", message("help_child")),
			otherWord("gravitropism", message("help_gravitropism")),
			otherWord("phototropism", message("help_phototropism")),
			otherWord("length", message("help_length")),
		];
	},
};
