/** The schema of leaf documents: table, presets and the outline. */
import { fromPreset } from "../../specimen/from_preset";
import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { outlinePoints } from "./details/outline";
import { DEFAULT_PRESET, PRESET_KINDS, PRESETS } from "./presets/presets";
import type { LeafSpecimen } from "./specimen";
import { LEAF_TABLE } from "./table";

export const LEAF: ModelSchema<LeafSpecimen> = {
	name: "leaf",
	table: LEAF_TABLE,
	presets: translatedPresets("leaf", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [outlinePoints],
};

/** Returns a new leaf from a preset (specimen/from_preset.ts). */
export function leafFromPreset(name?: string): LeafSpecimen {
	return fromPreset(LEAF, name);
}
