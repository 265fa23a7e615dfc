/** The plan language for the editor (docs/models/stand/language.md). */
import type { Dialect } from "../../../grammar_editor/dialect";
import type { Token, TokenKind } from "../../../grammar_editor/scan";

const TOKEN =
	/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|"[^"\n]*"?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\/[\p{L}\p{N}_-]*)?|[\s\S]/gu;
const STATEMENTS = new Set(["ground", "plants", "trellis"]);
const ITEMS = new Set(
	"relief hills stratified random blue rows towards jitter depth share crown scale seeds each height reach at posts wire pair x to".split(
		" ",
	),
);

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

const statement = (name: string, written: string, help: string) => ({
	kind: "statement" as const,
	name,
	written,
	help,
});
const word = (name: string, written: string, help: string) => ({ kind: "function" as const, name, written, help });

export const STAND_LANGUAGE: Dialect = {
	scan,
	words: [
		statement("ground", "ground 60 x 40, relief 2", "Width and depth of the ground, in metres."),
		statement(
			"plants",
			"plants 100, blue 2",
			"How many plants stand there, and how; below it what grows, a line each: model/preset.",
		),
		statement(
			"trellis",
			"trellis 2, posts 5, wire 0.9",
			"Posts and wires along the rows of plants above: how high posts are, metres.",
		),
		word("relief", "relief 2", "From the lowest place to the highest at the most, metres."),
		word("hills", "hills 20", "From one rise to the next, metres."),
		word("stratified", "stratified", "One plant in each cell of a grid, anywhere in it."),
		word("random", "random", "Anywhere, each by itself."),
		word("blue", "blue 1.5", "By chance, but none nearer to another than this, metres."),
		word("rows", "rows 2.5 x 1.2", "From row to row, and from plant to plant in a row, metres."),
		word("towards", "towards 30", "Where rows run, degrees from +x to +z."),
		word("jitter", "jitter 0.1", "How far plants may stand off their places in rows, metres."),
		word("depth", "depth 0 to 0.5", "A strip of the ground, from its back, 0, to its front, 1."),
		word("share", "share 3", "How many there are against the other lines’ shares."),
		word("crown", "crown 4 x 8", "Width of the crown and height of the plant, in metres: what neighbours know of it."),
		word("scale", "scale 0.8 to 1.2", "How large each is against what its preset says; drawn for each."),
		word("seeds", "seeds 8", "How many different ones there are: fewer are quicker to grow, and smaller in files."),
		word("each", "each 3 to 5", "Makes the line hang on the plants of the line above: so many on each."),
		word("at", "at bunch", "At which of its bearer’s organs it hangs, in place of height and reach."),
		word("posts", "posts 5", "From post to post at the most, metres; posts stand between plants."),
		word("wire", "wire 0.9", "A wire at that height, metres."),
		word("pair", "pair 1.2", "Two wires at that height, to both sides of the posts, metres."),
		word("height", "height 0.8 to 1", "How high what is borne hangs, metres."),
		word("reach", "reach 0.5", "How far along its bearer it hangs, metres each way."),
	],
};
