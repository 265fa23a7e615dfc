// Made from wasm-core/parameters/stand.json by wasm-core/tools/generate.mjs; edit the table, not this.
import type { Entry, Group } from "../../specimen/table";

/** Keys of the parameters that the core reads, in the request's order. */
export const NUMBER_KEYS = ["many", "relief"] as const;
export type NumberKey = (typeof NUMBER_KEYS)[number];

/** Keys of the parameters that only colour the result. */
export const LOOK_KEYS = ["soil", "detail"] as const;
export type LookKey = (typeof LOOK_KEYS)[number];
/** Those of them that are colours, as six hexadecimal digits. */
export type ColourKey = "soil";

/** Every parameter, in the order in which panels and pages show them. */
export const PARAMETERS: readonly Entry[] = [
	{
		key: "many",
		link: "many",
		label: "Plants",
		symbol: "",
		group: "plan",
		kind: "integer",
		unit: "",
		min: 0,
		max: 3000,
		default: 0,
		step: 10,
		zero: "auto",
		help: "How many plants stand there; 0: as many as the plan says.",
		since: 2,
	},
	{
		key: "relief",
		link: "relief",
		label: "Relief",
		symbol: "",
		group: "plan",
		kind: "number",
		unit: "×",
		min: 0,
		max: 3,
		default: 1,
		step: 0.05,
		help: "How high the ground's rises are against what the plan says.",
		since: 2,
	},
	{
		key: "soil",
		link: "soil",
		label: "Ground",
		symbol: "",
		group: "look",
		kind: "colour",
		unit: "",
		default: "6f7a4b",
		help: "Colour of the ground.",
		since: 2,
		look: true,
	},
	{
		key: "detail",
		link: "detail",
		label: "Fineness of files",
		symbol: "",
		group: "look",
		kind: "choice",
		unit: "",
		options: ["near", "middle", "far", "farthest"],
		min: 0,
		max: 3,
		default: 2,
		step: 1,
		help: "Which level of detail plants have in files. The view chooses by itself.",
		since: 2,
		look: true,
	},
];

/** The groups that panels and pages show, in order. */
export const GROUPS: readonly Group[] = [
	{ key: "plan", title: "Plan", help: "How many plants there are, on what ground.", everyday: true },
	{
		key: "look",
		title: "Look",
		help: "The ground's colour, and how fine plants are in files.",
		everyday: true,
		plain: true,
	},
];
