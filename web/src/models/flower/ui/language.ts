/** The flower language for the editor (docs/models/flower/language.md). */
import type { Dialect } from "../../../grammar_editor/dialect";
import type { Token, TokenKind } from "../../../grammar_editor/scan";

const PIECE =
	/\/\*[\s\S]*?(?:\*\/|$)|@[^@]*@?|\n|[ \t\r\f\v]+|-->|->|→|"[^"\n]*"?|#[ \t]*\p{L}+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\.\p{L}+)?|[<>=!]=|&&|\|\||[\s\S]/gu;

function kindOf(piece: string, before: string): TokenKind {
	if (piece.startsWith("/*") || piece.startsWith("@")) return "comment";
	if (piece.startsWith("#")) return "statement";
	if (/^(?:-->|->|→)$/.test(piece)) return "arrow";
	if (/^[\d.]/.test(piece) && piece !== ".") return "number";
	if (piece.startsWith('"')) return "symbol";
	if (/^\p{L}/u.test(piece)) return /^[ \t]*\(/.test(before) ? "function" : "name";
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

const statement = (name: string, written: string, help: string) => ({
	kind: "statement" as const,
	name,
	written,
	help,
});
const word = (name: string, help: string, written = name) => ({ kind: "function" as const, name, written, help });

export const FLOWER_LANGUAGE: Dialect = {
	scan,
	words: [
		statement(
			"-->",
			"A{before}{condition}{after} -> A[B(…)]_{E}",
			"On the face behind the bracket B grows, wherever there is an A for which the condition holds; the blocks may be missing.",
		),
		statement(
			"#define",
			"#define STEM(N, atx, aty, atz, H, L, W, m)",
			"A volume: sides, turns in degrees, height, length and width in millimetres, material. Or a variable: #define rd=7.",
		),
		statement("#axiom", "#axiom: STEM", "What it begins with."),
		statement("#module", "#module PETAL", "What follows is a grammar of its own, which &PETAL grows."),
		statement(
			"#material",
			'#material 4 petal "c8102e" "f6d55c" veins "8a1030" 9 0.5',
			"What m means: a number, a kind (stem, leaf, sepal, petal, stamen, pistil, seed), the colour at the foot and at the tip; then foot, margin, veins (feathered or not), light, bud, wilted and name.",
		),
		word("step", "The step of this grammar, from 0."),
		word("finalStep", "How many steps this grammar has; #define finalStep=12 says so."),
		word("age", "0 a bud, 1 open, 2 wilted."),
		word("face", "The number of the side that it grows on."),
		word("along", "How many volumes along the axis of its organ that stands which it grows from."),
		word("beside", "How many volumes beside the axis of its organ that stands which it grows from."),
		word("math.random", "A number drawn between two, for each volume.", "math.random(from, to)"),
	],
};
