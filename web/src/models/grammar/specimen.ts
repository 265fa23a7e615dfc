import type { WithConstants } from "../../specimen/constants";
import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { WithAreas } from "./areas/area";
import type { ColourKey, NumberKey } from "./parameters.generated";

/** The document of a plant that a text grows. */
export interface GrammarSpecimen extends Specimen, WithGrammar, WithConstants, WithAreas {
	/** Every parameter of wasm-core/parameters/grammar.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** The palette: six hexadecimal digits each, without `#`. */
	look: Record<ColourKey, string>;
	/** Of the derivation; as the text says where absent. */
	steps?: number;
}
