/** The growth language for the editor (docs/models/growth/language.md). */
import type { Dialect } from "../../../grammar_editor/dialect";
import type { Token, TokenKind } from "../../../grammar_editor/scan";

const PIECE =
	/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|-->|->|→|"[^"\n]*"?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\.\p{L}+)?|[<>=!]=|&&|\|\||[\s\S]/gu;
const STATEMENTS = new Set(["footprint", "tree", "gs", "bud"]);

function kindOf(piece: string, fresh: boolean, before: string): TokenKind {
	if (piece.startsWith("/*")) return "comment";
	if (/^(?:-->|->|→)$/.test(piece)) return "arrow";
	if (/^[\d.]/.test(piece) && piece !== ".") return "number";
	if (piece.startsWith('"')) return "symbol";
	if (/^\p{L}/u.test(piece)) {
		if (fresh && STATEMENTS.has(piece.split(".")[0])) return "statement";
		return /^[ \t]*\(/.test(before) ? "function" : "name";
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

const statement = (name: string, written: string, help: string) => ({
	kind: "statement" as const,
	name,
	written,
	help,
});
const word = (name: string, help: string, written = name) => ({ kind: "function" as const, name, written, help });

export const GROWTH_LANGUAGE: Dialect = {
	scan,
	words: [
		statement(
			"-->",
			"condition -> what follows : probability",
			"What stands behind the arrow follows where the condition holds.",
		),
		statement(
			"gs",
			"gs = 8",
			"How many growth steps the tree takes where nobody asks for others; gs.rand(7, 8) draws.",
		),
		statement("footprint", "footprint -> GrowVol(…)", "The growth volumes, each the trunk and crown of its own."),
		statement(
			"tree",
			'tree -> DivFunc("sigma1"){branches}',
			"The divisor functions that say how many branches and leaves there are.",
		),
		statement(
			"bud",
			"bud(k - 1) : condition -> branch : 0.9",
			"How many buds an internode bears, and with what probability each opens.",
		),
		word(
			"GrowVol",
			"A growth volume: how many, the first one’s number, width at the base, height and width at the top in metres, lean in degrees.",
			"GrowVol(cnt, id, wb, h, wt, grad)",
		),
		word(
			"DivFunc",
			'A divisor function: "sigma1", "sigma1b", "hat1", "star1"; "exp" is a factor of its argument.',
			"DivFunc(type, …){branches}",
		),
		word("k", "The shoot’s age in steps, from 1."),
		word("N", "One more than the age of its trunk: k == N - 1 is the trunk, k < N - 1 a branch."),
		word("ndv", "What the divisor functions say for this shoot at this step."),
		word("nbr", "How many branches it makes."),
		word("nlf", "How many leaves; below 0, as many fall."),
		word("D", "The divisor function of branches, of a whole number.", "D(k)"),
		word("E", "That of leaves.", "E(k)"),
		word("leaf", "Makes so many leaves.", "leaf(n)"),
		word("fallingLeaf", "Makes so many leaves fall.", "fallingLeaf(n)"),
		word("childTrunk", "Makes a child trunk, its volume from 1 to half its parent’s."),
		word("gravitropism", "How much shoots are drawn down."),
		word("phototropism", "How much they turn up to the light."),
		word("length", "Of a shoot against what it would be."),
	],
};
