// Made from wasm-core/parameters/flower.json by wasm-core/tools/generate.mjs; edit the table, not this.
import type { Entry, Group } from "../../specimen/table";

/** Keys of the parameters that the core reads, in the request's order. */
export const NUMBER_KEYS = ["steps", "age", "smooth"] as const;
export type NumberKey = (typeof NUMBER_KEYS)[number];

/** Keys of the parameters that only colour the result. */
export const LOOK_KEYS = [] as const;
export type LookKey = (typeof LOOK_KEYS)[number];
/** Those of them that are colours, as six hexadecimal digits. */
export type ColourKey = never;

/** Every parameter, in the order in which panels and pages show them. */
export const PARAMETERS: readonly Entry[] = [
	{
		key: "steps",
		link: "steps",
		label: "Steps",
		symbol: "finalStep",
		group: "life",
		kind: "integer",
		unit: "",
		min: 0,
		max: 400,
		default: 0,
		step: 1,
		zero: "auto",
		help: "Steps of the text itself; 0: as many as it says, and 10 where it says nothing. Modules have their own.",
		since: 2,
	},
	{
		key: "age",
		link: "age",
		label: "Age",
		symbol: "age",
		group: "life",
		kind: "number",
		unit: "",
		min: 0,
		max: 2,
		default: 1,
		step: 0.01,
		help: "What the text calls age: 0 a bud, 1 open, 2 wilted.",
		since: 2,
	},
	{
		key: "smooth",
		link: "smooth",
		label: "Smooth",
		symbol: "",
		group: "look",
		kind: "integer",
		unit: "",
		min: 0,
		max: 3,
		default: 1,
		step: 1,
		help: "How often its skin is rounded; 0: the volumes as they are.",
		since: 2,
	},
];

/** The groups that panels and pages show, in order. */
export const GROUPS: readonly Group[] = [
	{ key: "life", title: "Life", help: "How many steps the flower grows, and how far it has opened.", everyday: true },
	{ key: "look", title: "Shape", help: "How smooth it is.", everyday: true, closed: true },
];
