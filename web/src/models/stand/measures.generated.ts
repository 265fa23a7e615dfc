// Made from wasm-core/parameters/stand.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
import type { MeasureGroup, MeasureInfo } from "../../specimen/measures";

/** Keys of the measures, in the order in which the core gives them. */
export const MEASURE_KEYS = ["area", "standing", "density", "spacing", "cover"] as const;
export type MeasureKey = (typeof MEASURE_KEYS)[number];

/** Every measure, in the same order. */
export const MEASURES: readonly MeasureInfo[] = [
	{
		key: "area",
		label: "Area",
		group: "ground",
		kind: "number",
		unit: "m²",
		decimals: 1,
		help: "Width by depth.",
	},
	{
		key: "standing",
		label: "Standing plants",
		group: "stand",
		kind: "whole",
		unit: "",
		decimals: 0,
		help: "Plants that stand on the ground; those that others bear are not counted.",
	},
	{
		key: "density",
		label: "Density",
		group: "stand",
		kind: "number",
		unit: "/ha",
		decimals: 0,
		help: "Standing plants on a hectare.",
	},
	{
		key: "spacing",
		label: "Spacing",
		group: "stand",
		kind: "number",
		unit: "m",
		decimals: 2,
		help: "How far the nearest plant is, as a mean over all.",
	},
	{
		key: "cover",
		label: "Crown cover",
		group: "ground",
		kind: "number",
		unit: "%",
		decimals: 0,
		help: "Crowns' areas over the ground's; above 100 where they overlap.",
	},
];

/** The groups that panels and pages show, in order. */
export const MEASURE_GROUPS: readonly MeasureGroup[] = [
	{ key: "ground", title: "Ground" },
	{ key: "stand", title: "Stand" },
];
