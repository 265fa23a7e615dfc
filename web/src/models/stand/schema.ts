/** The document's side of the model: its table, its presets, and what a specimen of it holds besides. */
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { Presets } from "../../specimen/presets";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { StandSpecimen } from "./specimen";
import { STAND_TABLE } from "./table";

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "ecosystem-500";

/** What begins a line of a plan: an L-system may call a symbol so, but has an axiom. */
const OWN = /^[ \t]*plants[ \t]*[\d,]/m;
const AXIOM = /^[ \t]*axiom[ \t]*:/im;

export const STAND: ModelSchema<StandSpecimen> = {
	name: "stand",
	table: STAND_TABLE,
	presets: new Presets(PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [grammarText((text) => OWN.test(text) && !AXIOM.test(text))],
};
