import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { ColourKey, NumberKey } from "./parameters.generated";

/** The document of a plant that a text grows. */
export interface GrammarSpecimen extends Specimen, WithGrammar {
	/** Every parameter of wasm-core/parameters/grammar.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** The palette: six hexadecimal digits each, without `#`. */
	look: Record<ColourKey, string>;
	/** Values for the text's `#define`s and `#input`s, by name, in the order of the alphabet; those not here have what the text says. */
	constants: Record<string, number>;
	/** Of the derivation; as the text says where absent. */
	steps?: number;
}
