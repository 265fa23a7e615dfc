/** The toy's web side: with toy.cpp (its core) and toy.json (its table) a whole model, without a line about it elsewhere. */
import type { Block } from "../../web/src/core/container";
import type { PageModel } from "../../web/src/models/page_model";
import { partsOf } from "../../web/src/plant/parts_of";
import type { Plant } from "../../web/src/plant/plant";
import { readPlant } from "../../web/src/plant/read_plant";
import { grammarText, type WithGrammar } from "../../web/src/specimen/grammar_text";
import { type Preset, Presets } from "../../web/src/specimen/presets";
import type { Specimen } from "../../web/src/specimen/specimen";
import { type ParameterEntry, Table } from "../../web/src/specimen/table";
import source from "./toy.json";

export type ToySpecimen = Specimen & WithGrammar;

const GRAMMAR = `#define height 40
#define spread 35
axiom: !(4) A(3)
A(n) : n>0 --> F(height) [ +(spread) A(n-1) ] [ /(120) +(spread) A(n-1) ] [ /(240) +(spread+ran(10)) A(n-1) ]
A(n) : n=0 --> !(2) F(height/2) S(height/5)
`;

const table = new Table(source.parameters as readonly ParameterEntry[], source.groups);

const preset = (name: string, title: string, parameters: Preset["parameters"]): Preset => ({
	name,
	kind: "shrub",
	title,
	about: `A ${title.toLowerCase()}.`,
	parameters,
	look: {},
});

export const model: PageModel<ToySpecimen, Plant> = {
	name: "toy",
	title: "Toy shrub",
	plantName: "shrub",
	wasm: "toy.wasm",
	pictures: false,
	table,
	presets: new Presets(
		[preset("upright", "Upright shrub", { spread: 15 }), preset("open", "Open shrub", { spread: 60 })],
		[{ key: "shrub", title: "Shrubs", family: "trees" }],
		"upright",
	),
	details: [grammarText<ToySpecimen>()],
	encode({ seed, parameters, grammar = GRAMMAR }, { meshes = true } = {}): Block[] {
		return [
			{ name: "model", data: "toy" },
			{ name: "seed", data: Uint32Array.of(seed) },
			{ name: "outputs", data: meshes ? "meshes sky" : "" },
			{ name: "parameters", data: Float32Array.from(table.core, ({ key }) => parameters[key]) },
			{ name: "grammar", data: grammar },
		];
	},
	read: readPlant,
	parts: (plant) => partsOf(plant),
	summary: ({ counts }) => `${counts.segments} twigs, ${counts.organs} fruits`,
};
