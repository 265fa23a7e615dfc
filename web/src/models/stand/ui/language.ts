/** The plan language for the editor (docs/models/stand/language.md). */

import type { Dialect } from "../../../grammar_editor/dialect";
import { innerWord, isName, statementScanner, statementWord } from "../../../grammar_editor/statement_language";
import { text as message } from "../messages.generated";

const STATEMENTS = new Set(["ground", "plants", "trellis"]);
const ITEMS = new Set(
	"relief hills stratified random blue rows towards jitter depth share crown scale seeds each height reach at posts wire pair x to".split(
		" ",
	),
);

const scan = statementScanner({
	token:
		/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|"[^"\n]*"?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\/[\p{L}\p{N}_-]*)?|[\s\S]/gu,
	kindOf(token, isFirst) {
		if (!isName(token)) return undefined;
		if (isFirst) return STATEMENTS.has(token) ? "statement" : "symbol";
		return ITEMS.has(token) ? "function" : "name";
	},
});

export const STAND_LANGUAGE: Dialect = {
	scan,
	/** Statements and words with their explanations, for completion and for the word at the cursor. */
	get words() {
		return [
			statementWord("ground", "ground 60 x 40, relief 2", message("help_ground")),
			statementWord("plants", "plants 100, blue 2", message("help_plants")),
			statementWord("trellis", "trellis 2, posts 5, wire 0.9", message("help_trellis")),
			innerWord("relief", message("help_relief"), "relief 2"),
			innerWord("hills", message("help_hills"), "hills 20"),
			innerWord("stratified", message("help_stratified")),
			innerWord("random", message("help_random")),
			innerWord("blue", message("help_blue"), "blue 1.5"),
			innerWord("rows", message("help_rows"), "rows 2.5 x 1.2"),
			innerWord("towards", message("help_towards"), "towards 30"),
			innerWord("jitter", message("help_jitter"), "jitter 0.1"),
			innerWord("depth", message("help_depth"), "depth 0 to 0.5"),
			innerWord("share", message("help_share"), "share 3"),
			innerWord("crown", message("help_crown"), "crown 4 x 8"),
			innerWord("scale", message("help_scale"), "scale 0.8 to 1.2"),
			innerWord("seeds", message("help_seeds"), "seeds 8"),
			innerWord("each", message("help_each"), "each 3 to 5"),
			innerWord("at", message("help_at"), "at bunch"),
			innerWord("posts", message("help_posts"), "posts 5"),
			innerWord("wire", message("help_wire"), "wire 0.9"),
			innerWord("pair", message("help_pair"), "pair 1.2"),
			innerWord("height", message("help_height"), "height 0.8 to 1"),
			innerWord("reach", message("help_reach"), "reach 0.5"),
		];
	},
};
