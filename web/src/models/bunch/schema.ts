/** The bunch's side of the document: its table, its presets, and what a specimen of it holds besides. */
import { fromPreset } from "../../specimen/from_preset";
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { Presets } from "../../specimen/presets";
import { PROCEDURES, type Procedure } from "./bunch_plant";
import { grammarInputs } from "./details/inputs";
import { radii } from "./details/radii";
import { thinnedBerries } from "./details/thinned";
import { DEFAULT_PRESET, PRESET_KINDS, PRESETS } from "./presets/presets";
import { metresPerPixel } from "./profile/handles";
import type { BunchSpecimen } from "./specimen";
import { BUNCH_TABLE } from "./table";

/** What symbols may be to a bunch (wasm-core/src/models/bunch/roles.cpp). */
const ROLE = /^[ \t]*#role[ \t]+(?:rachis|axis|end|pedicel)\b/m;

export const BUNCH: ModelSchema<BunchSpecimen> = {
	name: "bunch",
	unnamed: true,
	table: BUNCH_TABLE,
	presets: new Presets(PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	lengths: ({ parameters: { unit } }) => ({ px: 1000 * metresPerPixel(unit), u: unit }),
	details: [thinnedBerries, grammarInputs, grammarText((text) => ROLE.test(text)), radii],
};

/** A fresh bunch (specimen/from_preset.ts). */
export function specimenFromPreset(name?: string, version?: number): BunchSpecimen {
	return fromPreset(BUNCH, name, version);
}

/** By which procedure a bunch grows. */
export function procedureOf({ parameters }: Pick<BunchSpecimen, "parameters">): Procedure {
	return PROCEDURES[parameters.procedure];
}

/** Whether leaves grow with it: only a natural bunch hangs on a cane. */
export function hasLeaves(specimen: Pick<BunchSpecimen, "parameters">): boolean {
	return procedureOf(specimen) === "natural" && specimen.parameters.leaves > 0;
}
