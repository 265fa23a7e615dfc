/** The plan language for the editor (docs/models/stand/language.md). */

import type { Dialect } from "../../../grammar_editor/dialect";
import type { Token, TokenKind } from "../../../grammar_editor/scan";
import { text as message } from "../messages.generated";

const TOKEN =
	/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|"[^"\n]*"?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\/[\p{L}\p{N}_-]*)?|[\s\S]/gu;
const STATEMENTS = new Set(["ground", "plants", "trellis"]);
const ITEMS = new Set(
	"relief hills stratified random blue rows towards jitter depth share crown scale seeds each height reach at posts wire pair x to".split(
		" ",
	),
);

/**
 * Classifies a piece of text for colouring.
 * @param fresh whether it begins a statement
 */
function kindOf(piece: string, fresh: boolean): TokenKind {
	if (piece.startsWith("/*")) return "comment";
	if (/^[\d.]/.test(piece) && piece !== ".") return "number";
	if (piece.startsWith('"')) return "symbol";
	if (/^\p{L}/u.test(piece)) {
		if (fresh) return STATEMENTS.has(piece) ? "statement" : "symbol";
		return ITEMS.has(piece) ? "function" : "name";
	}
	return /^[-+*/^]$/.test(piece) ? "operator" : "mark";
}

/** Splits a text into tokens without white space. */
function scan(text: string): Token[] {
	const tokens: Token[] = [];
	let line = 1;
	let fresh = true;
	for (const match of text.matchAll(TOKEN)) {
		const [piece] = match;
		if (piece === "\n") {
			line++;
			fresh = true;
			continue;
		}
		if (/^[ \t\r\f\v]/.test(piece)) continue;
		const kind = kindOf(piece, fresh);
		tokens.push({ kind, from: match.index, to: match.index + piece.length, text: piece, line });
		line += piece.split("\n").length - 1;
		if (kind !== "comment") fresh = false;
	}
	return tokens;
}

/**
 * Describes a statement of the language for completion and help.
 * @param written an example
 * @param help its explanation
 */
const describeStatement = (name: string, written: string, help: string) => ({
	kind: "statement" as const,
	name,
	written,
	help,
});
/**
 * Describes a word inside statements, for completion and help.
 * @param written an example
 * @param help its explanation
 */
const describeWord = (name: string, written: string, help: string) => ({
	kind: "function" as const,
	name,
	written,
	help,
});

export const STAND_LANGUAGE: Dialect = {
	scan,
	/** Statements and words with their explanations, for completion and for the word at the cursor. */
	get words() {
		return [
			describeStatement("ground", "ground 60 x 40, relief 2", message("help_ground")),
			describeStatement("plants", "plants 100, blue 2", message("help_plants")),
			describeStatement("trellis", "trellis 2, posts 5, wire 0.9", message("help_trellis")),
			describeWord("relief", "relief 2", message("help_relief")),
			describeWord("hills", "hills 20", message("help_hills")),
			describeWord("stratified", "stratified", message("help_stratified")),
			describeWord("random", "random", message("help_random")),
			describeWord("blue", "blue 1.5", message("help_blue")),
			describeWord("rows", "rows 2.5 x 1.2", message("help_rows")),
			describeWord("towards", "towards 30", message("help_towards")),
			describeWord("jitter", "jitter 0.1", message("help_jitter")),
			describeWord("depth", "depth 0 to 0.5", message("help_depth")),
			describeWord("share", "share 3", message("help_share")),
			describeWord("crown", "crown 4 x 8", message("help_crown")),
			describeWord("scale", "scale 0.8 to 1.2", message("help_scale")),
			describeWord("seeds", "seeds 8", message("help_seeds")),
			describeWord("each", "each 3 to 5", message("help_each")),
			describeWord("at", "at bunch", message("help_at")),
			describeWord("posts", "posts 5", message("help_posts")),
			describeWord("wire", "wire 0.9", message("help_wire")),
			describeWord("pair", "pair 1.2", message("help_pair")),
			describeWord("height", "height 0.8 to 1", message("help_height")),
			describeWord("reach", "reach 0.5", message("help_reach")),
		];
	},
};
