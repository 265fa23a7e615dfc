// Made from wasm-core/parameters/flower.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
import type { MeasureGroup, MeasureInfo } from "../../specimen/measures";

/** Keys of the measures, in the order in which the core gives them. */
export const MEASURE_KEYS = ["height", "spread", "surface", "organs"] as const;
export type MeasureKey = (typeof MEASURE_KEYS)[number];

/** Every measure, in the same order. */
export const MEASURES: readonly MeasureInfo[] = [
	{
		key: "height",
		label: "Height",
		group: "size",
		kind: "number",
		unit: "cm",
		decimals: 1,
		help: "From its lowest to its highest place.",
	},
	{
		key: "spread",
		label: "Spread",
		group: "size",
		kind: "number",
		unit: "cm",
		decimals: 1,
		help: "The mean of its widths along x and z.",
	},
	{
		key: "surface",
		label: "Surface",
		group: "size",
		kind: "number",
		unit: "cm²",
		decimals: 0,
		help: "Area of its whole skin, both sides of petals and leaves.",
	},
	{
		key: "organs",
		label: "Organs",
		group: "parts",
		kind: "whole",
		unit: "",
		decimals: 0,
		help: "How many modules there are: petals, stamens and the like, those of organs among them.",
	},
];

/** The groups that panels and pages show, in order. */
export const MEASURE_GROUPS: readonly MeasureGroup[] = [
	{ key: "size", title: "Size" },
	{ key: "parts", title: "Parts" },
];
