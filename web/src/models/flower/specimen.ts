import type { WithConstants } from "../../specimen/constants";
import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { NumberKey } from "./parameters.generated";

/** The document of a flower. */
export interface FlowerSpecimen extends Specimen, WithGrammar, WithConstants {
	/** Every parameter of wasm-core/parameters/flower.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	look: Record<string, never>;
}
