import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { ColourKey, LookKey, NumberKey } from "./parameters.generated";

/** Document of a bunch. */
export interface BunchSpecimen extends Specimen, WithGrammar {
	/** Every parameter of wasm-core/parameters/bunch.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	look: Look;
	/** Ids of berries removed by hand (`Berries.ids`), in order of removal. */
	thinned: number[];
	/** Grammar inputs, in place of those computed from the profile: `n` is n₁ … n₍m−1₎ in the paper's numbering. */
	inputs?: { m?: number; n?: number[] };
}

/** Colours as six hexadecimal digits without `#`, the others numbers. */
export type Look = { [K in LookKey]: K extends ColourKey ? string : number };
