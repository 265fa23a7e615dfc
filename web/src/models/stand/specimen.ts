import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { ColourKey, LookKey, NumberKey } from "./parameters.generated";

/** The document of a stand. Its plan is in `grammar`, as the texts of other models. */
export interface StandSpecimen extends Specimen, WithGrammar {
	/** Every parameter of wasm-core/parameters/stand.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** Colours as six hexadecimal digits without `#`, the others numbers. */
	look: { [K in LookKey]: K extends ColourKey ? string : number };
}
