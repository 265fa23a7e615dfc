/** Schema of the model's document: its parameters, presets and further fields. */
import { constantValues } from "../../specimen/constants";
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { areas, from, path } from "./details/areas";
import { steps } from "./details/steps";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { GrammarSpecimen } from "./specimen";
import { GRAMMAR_TABLE } from "./table";
import { definedNames } from "./texts";

/** Preset of a link without `preset`. */
export const DEFAULT_PRESET = "shrub";

export const GRAMMAR: ModelSchema<GrammarSpecimen> = {
	name: "grammar",
	table: GRAMMAR_TABLE,
	presets: translatedPresets("grammar", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [steps, constantValues<GrammarSpecimen>(definedNames), areas, path, from, grammarText("any")],
};
