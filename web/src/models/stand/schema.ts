/** The schema of stand documents: table, presets and the plan. */
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { StandSpecimen } from "./specimen";
import { STAND_TABLE } from "./table";

/** The preset of links without `preset`. */
export const DEFAULT_PRESET = "ecosystem-500";

/** Start of a statement of a plan. A symbol of an L-system may have the same name, but an L-system has an axiom. */
const OWN = /^[ \t]*plants[ \t]*[\d,]/m;
const AXIOM = /^[ \t]*axiom[ \t]*:/im;

export const STAND: ModelSchema<StandSpecimen> = {
	name: "stand",
	table: STAND_TABLE,
	presets: translatedPresets("stand", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [grammarText((text) => OWN.test(text) && !AXIOM.test(text))],
};
