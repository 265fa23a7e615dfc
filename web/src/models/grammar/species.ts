/** The document's side of the model: its table, its presets, and what a specimen of it holds besides. */
import { grammarText } from "../../specimen/grammar_text";
import { Presets } from "../../specimen/presets";
import type { Species } from "../../specimen/species";
import { constants } from "./details/constants";
import { steps } from "./details/steps";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { GrammarSpecimen } from "./specimen";
import { GRAMMAR_TABLE } from "./table";

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "shrub";

export const GRAMMAR: Species<GrammarSpecimen> = {
	name: "grammar",
	table: GRAMMAR_TABLE,
	presets: new Presets(PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	// Any text that no other model has claimed.
	details: [steps, constants, grammarText(() => true)],
};
