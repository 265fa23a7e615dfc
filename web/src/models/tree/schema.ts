/** The schema of tree documents: table, presets and further fields. */

import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { obstaclesOf, roundsOf, targetsOf } from "../particles/boundary/details/places";
import { profileOf } from "../particles/boundary/details/profile";
import { hollowOf, volumeOf } from "../particles/boundary/details/volume";
import { DEFAULT_PRESET, PRESET_KINDS, PRESETS } from "./presets/presets";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";

export const TREE: ModelSchema<TreeSpecimen> = {
	name: "tree",
	table: TREE_TABLE,
	presets: translatedPresets("tree", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [profileOf(), targetsOf(), obstaclesOf(), roundsOf(), volumeOf(TREE_TABLE), hollowOf()],
};
