/** Schema of a tree's document: its parameters, presets and further fields. */
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { surroundingsDetail } from "../../specimen/surroundings";
import { translatedPresets } from "../../specimen/translated_tables";
import { branchEdits } from "./edits/edits_field";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";

/** Preset of a link without `preset`. */
export const DEFAULT_PRESET = "figure-5";

/** Matches a line of a growth grammar. An L-system may use these names as symbols, but has an axiom. */
const OWN = /^[ \t]*(?:footprint|tree)[ \t]*(?:-->|->|→)/m;
const AXIOM = /^[ \t]*axiom[ \t]*:/im;

export const GROWTH: ModelSchema<GrowthSpecimen> = {
	name: "growth",
	table: GROWTH_TABLE,
	presets: translatedPresets("growth", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [grammarText((text) => OWN.test(text) && !AXIOM.test(text)), surroundingsDetail(), branchEdits],
};
