/** Schema of a bunch's document: its parameters, presets and further fields. */
import { fromPreset } from "../../specimen/from_preset";
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { PROCEDURES, type Procedure } from "./bunch_plant";
import { grammarInputs } from "./details/inputs";
import { radii } from "./details/radii";
import { thinnedBerries } from "./details/thinned";
import { DEFAULT_PRESET, PRESET_KINDS, PRESETS } from "./presets/presets";
import { metresPerPixel } from "./profile/handles";
import type { BunchSpecimen } from "./specimen";
import { BUNCH_TABLE } from "./table";

/** Matches the declaration of a symbol's role in a bunch (wasm-core/src/models/bunch/roles.cpp). */
const ROLE = /^[ \t]*#role[ \t]+(?:rachis|axis|end|pedicel)\b/m;

export const BUNCH: ModelSchema<BunchSpecimen> = {
	name: "bunch",
	unnamed: true,
	table: BUNCH_TABLE,
	presets: translatedPresets("bunch", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	lengths: ({ parameters: { unit } }) => ({ px: 1000 * metresPerPixel(unit), u: unit }),
	details: [thinnedBerries, grammarInputs, grammarText((text) => ROLE.test(text)), radii],
};

/** Returns a new bunch from a preset (specimen/from_preset.ts). */
export function specimenFromPreset(name?: string, version?: number): BunchSpecimen {
	return fromPreset(BUNCH, name, version);
}

/** Returns the procedure of a bunch. */
export function procedureOf({ parameters }: Pick<BunchSpecimen, "parameters">): Procedure {
	return PROCEDURES[parameters.procedure];
}

/** Returns whether a bunch has leaves: only natural bunches hang on a cane. */
export function hasLeaves(specimen: Pick<BunchSpecimen, "parameters">): boolean {
	return procedureOf(specimen) === "natural" && specimen.parameters.leaves > 0;
}
