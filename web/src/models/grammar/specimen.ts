import type { WithConstants } from "../../specimen/constants";
import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { WithAreas } from "./areas/area";
import type { ColourKey, NumberKey } from "./parameters.generated";

/** Document of a text's plant. */
export interface GrammarSpecimen extends Specimen, WithGrammar, WithConstants, WithAreas {
	/** Every parameter of wasm-core/parameters/grammar.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** Palette, six hexadecimal digits each, without `#`. */
	look: Record<ColourKey, string>;
	/** Number of derivation steps; the text's own if absent. */
	steps?: number;
}
