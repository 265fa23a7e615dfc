/** The field of models that grow by a grammar: a text in place of the built-in one. */
import { GRAMMAR_BYTES, textLengthProblem } from "./limits";
import type { Field } from "./model_schema";
import { type Notes, quote } from "./notes";
import type { Specimen } from "./specimen";

/** A specimen with this field. */
export interface WithGrammar {
	/** Grammar text in place of the built-in one. */
	grammar?: string;
}

const BUILT_IN = "the built-in grammar is used";

/**
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
			otherwise: BUILT_IN,
			textOf: ({ grammar }) => grammar,
		},
	};
}

/** Line ends become those of the page, because the text is compared with texts that the page writes. */
function readGrammar(specimen: WithGrammar, value: unknown, notes: Notes): void {
	const problem = typeof value === "string" ? textLengthProblem(value) : `${quote(value)} is not text`;
	if (problem) notes.add("grammar", problem, specimen.grammar ? "the one before is used" : BUILT_IN);
	else if (value === "") delete specimen.grammar;
	else specimen.grammar = wellFormed(value as string).replaceAll("\r\n", "\n");
}

/** Replaces half a surrogate pair, which has no UTF-8: no link or request could carry it. */
function wellFormed(text: string): string {
	return new TextDecoder("utf-8", { ignoreBOM: true }).decode(new TextEncoder().encode(text));
}
