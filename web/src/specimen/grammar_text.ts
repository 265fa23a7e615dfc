/** The field of models that grow by a grammar: a text in place of the built-in one. */
import { GRAMMAR_BYTES, textLengthProblem } from "./limits";
import { text } from "./messages.generated";
import type { Field } from "./model_schema";
import { type Notes, quote } from "./notes";
import type { Specimen } from "./specimen";

/** A specimen with this field. */
export interface WithGrammar {
	/** Grammar text in place of the built-in one. */
	grammar?: string;
}

/**
 * Creates the field.
 * @param claims whether a text without a model's name is for this model; "any": each that no other model claims;
 * absent: none
 */
export function grammarText<S extends Specimen & WithGrammar>(claims?: ((text: string) => boolean) | "any"): Field<S> {
	return {
		keys: ["grammar"],
		...(claims === "any" ? { takesAny: true } : claims ? { claims } : {}),
		read: (specimen, _, value, notes) => readGrammar(specimen, value, notes),
		packed: {
			link: "g",
			key: "grammar",
			longest: GRAMMAR_BYTES,
			get otherwise() {
				return text("built_in_grammar_used");
			},
			textOf: ({ grammar }) => grammar,
		},
	};
}

/**
 * Reads a text into a specimen, with line ends as the page writes them; an empty text removes the specimen's own. Notes
 * an unusable value, which changes nothing.
 */
function readGrammar(specimen: WithGrammar, value: unknown, notes: Notes): void {
	const problem =
		typeof value === "string" ? textLengthProblem(value) : text.message("not_text", { value: quote(value) });
	if (problem) notes.add("grammar", problem, text(specimen.grammar ? "grammar_kept" : "built_in_grammar_used"));
	else if (value === "") delete specimen.grammar;
	else specimen.grammar = wellFormed(value as string).replaceAll("\r\n", "\n");
}

/** Replaces half a surrogate pair, which has no UTF-8: no link or request could carry it. */
function wellFormed(text: string): string {
	return new TextDecoder("utf-8", { ignoreBOM: true }).decode(new TextEncoder().encode(text));
}
