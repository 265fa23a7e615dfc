/** The schema of root documents: table, presets and further fields. */

import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { obstaclesOf, roundsOf, targetsOf } from "../particles/boundary/details/places";
import { profileOf } from "../particles/boundary/details/profile";
import { hollowOf, volumeOf } from "../particles/boundary/details/volume";
import { DEFAULT_PRESET, PRESET_KINDS, PRESETS } from "./presets/presets";
import type { RootSpecimen } from "./specimen";
import { ROOT_TABLE } from "./table";

export const ROOT: ModelSchema<RootSpecimen> = {
	name: "root",
	table: ROOT_TABLE,
	presets: translatedPresets("root", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [profileOf(), targetsOf(), obstaclesOf(), roundsOf(), volumeOf(ROOT_TABLE), hollowOf()],
};
