/** A model of a few lines, for tests of code that knows no model: a pole of some height, with a flag that may have a motto. */
import type { Model } from "../../web/src/models/model";
import { EMPTY_PLANT, type Plant } from "../../web/src/plant/plant";
import type { MeasureInfo } from "../../web/src/specimen/measures";
import type { Field } from "../../web/src/specimen/model_schema";
import { numbersIn, type Preset, Presets } from "../../web/src/specimen/presets";
import type { Specimen } from "../../web/src/specimen/specimen";
import { type ParameterEntry, Table } from "../../web/src/specimen/table";

export interface ToySpecimen extends Specimen {
	/** The text on the flag. */
	motto: string;
}

const common = { symbol: "", group: "pole", since: 2, help: "A help." };
const ENTRIES: readonly ParameterEntry[] = [
	{
		...common,
		key: "height",
		link: "h",
		label: "Height",
		kind: "number",
		unit: "m",
		min: 1,
		max: 9,
		default: 4,
		step: 1,
	},
	{
		...common,
		key: "flag",
		link: "flag",
		label: "Flag",
		kind: "choice",
		unit: "",
		options: ["none", "square"],
		min: 0,
		max: 1,
		default: 0,
		step: 1,
	},
	{
		...common,
		key: "wind",
		link: "wind",
		label: "Wind",
		kind: "integer",
		unit: "",
		min: 0,
		max: 12,
		default: 3,
		step: 1,
		where: { flag: "square" },
	},
	{ ...common, key: "paint", link: "paint", label: "Paint", kind: "colour", unit: "", default: "ff0000", look: true },
];
const MEASURES: readonly MeasureInfo[] = [
	{
		key: "shade",
		label: "Shade",
		group: "sun",
		kind: "number",
		unit: "m",
		decimals: 1,
		help: "How long.",
	},
];

const TABLE = new Table(
	ENTRIES,
	[
		{ key: "pole", title: "Pole", help: "What stands." },
		{ key: "rest", title: "Rest", help: "What is left.", closed: true },
	],
	MEASURES,
	[{ key: "sun", title: "Sun" }],
);

/** A text that links pack into their fragment. */
const motto: Field<ToySpecimen> = {
	keys: ["motto"],
	fresh: () => ({ motto: "" }),
	read: (specimen, key, value, notes) => {
		if (typeof value === "string") specimen.motto = value;
		else notes.add(key, { code: "toy.not_text", args: {}, text: "It is not text." }, "None is used.");
	},
	packed: {
		link: "t",
		key: "motto",
		longest: 100,
		otherwise: "None is used.",
		textOf: ({ motto }) => motto || undefined,
	},
};

const preset = (name: string, kind: string, more: Partial<Preset> = {}): Preset => ({
	name,
	kind,
	title: name.charAt(0).toUpperCase() + name.slice(1),
	about: `A ${name} pole.`,
	parameters: {},
	look: {},
	...more,
});

export const toy: Model<ToySpecimen, Plant> = {
	name: "toy",
	title: "Flagpole",
	plantName: "pole",
	wasm: "toy.wasm",
	table: TABLE,
	presets: new Presets(
		[
			preset("plain", "bare"),
			preset("märz", "flown", {
				parameters: numbersIn(TABLE, { flag: "square", wind: 7 }),
				details: { motto: "Vorwärts" },
			}),
		],
		[
			{ key: "bare", title: "Bare", family: "trees" },
			{ key: "flown", title: "Flown", family: "flowers" },
		],
		"plain",
	),
	details: [motto],
	encode: (specimen) => [
		{ name: "model", data: "toy" },
		{ name: "seed", data: Uint32Array.of(specimen.seed) },
	],
	read: ({ columns, milliseconds }) => ({
		...EMPTY_PLANT,
		fingerprint: columns.text("fingerprint"),
		timings: { grow: milliseconds },
	}),
	*parts() {},
	summary: (_, { parameters: { height } }) => `${height} m tall`,
};
