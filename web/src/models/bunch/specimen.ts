import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { ColourKey, LookKey, NumberKey } from "./parameters.generated";

/** The document of a bunch. */
export interface BunchSpecimen extends Specimen, WithGrammar {
	/** Every parameter of wasm-core/parameters/bunch.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	look: Look;
	/** Ids of berries taken off by hand (`Berries.ids`), in the order in which they were. */
	thinned: number[];
	/** The grammar's own inputs, in place of those the profile gives: `n` is n₁ … n₍m−1₎ as the paper counts. */
	inputs?: { m?: number; n?: number[] };
}

/** Colours as six hexadecimal digits without `#`, the others numbers. */
export type Look = { [K in LookKey]: K extends ColourKey ? string : number };
