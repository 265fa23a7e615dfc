/** The growth language for the editor (docs/models/growth/language.md). */

import type { Dialect } from "../../../grammar_editor/dialect";
import { innerWord, isName, statementScanner, statementWord } from "../../../grammar_editor/statement_language";
import { text as message } from "../messages.generated";

const STATEMENTS = new Set(["footprint", "tree", "gs", "bud"]);

const scan = statementScanner({
	token:
		/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|-->|->|→|"[^"\n]*"?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\.\p{L}+)?|[<>=!]=|&&|\|\||[\s\S]/gu,
	kindOf(token, isFirst, isCalled) {
		if (!isName(token)) return undefined;
		if (isFirst && STATEMENTS.has(token.split(".")[0])) return "statement";
		return isCalled ? "function" : "name";
	},
});

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
			innerWord("GrowVol", message("help_growvol"), "GrowVol(cnt, id, wb, h, wt, grad)"),
			innerWord("DivFunc", message("help_divfunc"), "DivFunc(type, …){branches}"),
			innerWord("k", message("help_k")),
			innerWord("N", message("help_n")),
			innerWord("ndv", message("help_ndv")),
			innerWord("nbr", message("help_nbr")),
			innerWord("nlf", message("help_nlf")),
			innerWord("D", message("help_d"), "D(k)"),
			innerWord("E", message("help_e"), "E(k)"),
			innerWord("leaf", message("help_leaf"), "leaf(n)"),
			innerWord("fallingLeaf", message("help_falling"), "fallingLeaf(n)"),
			innerWord("childTrunk", message("help_child")),
			innerWord("gravitropism", message("help_gravitropism")),
			innerWord("phototropism", message("help_phototropism")),
			innerWord("length", message("help_length")),
		];
	},
};
