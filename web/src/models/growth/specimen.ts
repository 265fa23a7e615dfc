import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { WithSurroundings } from "../../specimen/surroundings";
import type { BranchEdit } from "./edits/branch_edit";
import type { ColourKey, LookKey, NumberKey } from "./parameters.generated";

/** The document of a tree that a growth grammar grows. */
export interface GrowthSpecimen extends Specimen, WithGrammar, WithSurroundings {
	/** Every parameter of wasm-core/parameters/growth.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** Edits of single branches by hand, in the order in which they were made. */
	edits: readonly BranchEdit[];
	/** Colours as six hexadecimal digits without `#`, the others numbers. */
	look: { [K in LookKey]: K extends ColourKey ? string : number };
}
