/** The flower language for the editor (docs/models/flower/language.md). */

import type { Dialect } from "../../../grammar_editor/dialect";
import { innerWord, isName, statementScanner, statementWord } from "../../../grammar_editor/statement_language";
import { text as message } from "../messages.generated";

/** Splits a text into tokens, without blanks. A comment may also stand between two at signs. */
export const scan = statementScanner({
	token:
		/\/\*[\s\S]*?(?:\*\/|$)|@[^@]*@?|\n|[ \t\r\f\v]+|-->|->|→|"[^"\n]*"?|#[ \t]*\p{L}+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\p{L}[\p{L}\p{N}_]*(?:\.\p{L}+)?|[<>=!]=|&&|\|\||[\s\S]/gu,
	kindOf(token, _, isCalled) {
		if (token.startsWith("@")) return "comment";
		if (token.startsWith("#")) return "statement";
		if (!isName(token)) return undefined;
		return isCalled ? "function" : "name";
	},
});

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
			innerWord("step", message("help_step")),
			innerWord("finalStep", message("help_final_step")),
			innerWord("age", message("help_age")),
			innerWord("face", message("help_face")),
			innerWord("along", message("help_along")),
			innerWord("beside", message("help_beside")),
			innerWord("math.random", message("help_random"), "math.random(from, to)"),
		];
	},
};
