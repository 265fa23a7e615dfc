/** The document's side of the model: its table, its presets, and what a specimen of it holds besides. */
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { Presets } from "../../specimen/presets";
import { surroundingsDetail } from "../../specimen/surroundings";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "figure-5";

/** What begins a line of a growth grammar: an L-system may call a symbol so, but has an axiom. */
const OWN = /^[ \t]*(?:footprint|tree)[ \t]*(?:-->|->|→)/m;
const AXIOM = /^[ \t]*axiom[ \t]*:/im;

export const GROWTH: ModelSchema<GrowthSpecimen> = {
	name: "growth",
	table: GROWTH_TABLE,
	presets: new Presets(PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [grammarText((text) => OWN.test(text) && !AXIOM.test(text)), surroundingsDetail()],
};
