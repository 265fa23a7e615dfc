/** Columns of an answer → what a text has grown (wasm-core/src/models/grammar/model.hpp). */
import type { Answer } from "../../core/core";
import type { Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";
import type { Area, WithAreas } from "./areas/area";

/** What of drawn things is not their shape, one each. */
export interface Marks {
	/** The module that drew it, by its place in the last string, from 0. */
	module: Uint32Array;
	/** 1 … 8 of the palette. */
	colour: Uint8Array;
}

/** A plant that a text has grown. */
export interface GrammarPlant extends Plant {
	/** Of segments. */
	lines: Marks;
	/** Of organs. */
	organMarks: Marks;
	/** Of segments, where the text says it: the growth area of each, from 1, 0 for none, and whether it is the main branch's. */
	belongs?: { area: Uint8Array; main: Uint8Array };
	/** That it has grown in, where there are such. */
	areas?: readonly Area[];
	/** Of growth areas, where they were measured: m³, and the share of the surface that is clothed. */
	areaMeasures?: { volume: Float32Array; clothed: Float32Array };
	/** Colours of each mesh's runs, by the mesh's name. */
	runColours: Readonly<Record<string, Uint8Array>>;
	/** The organ that each run of the mesh `blades` is, where that is told. */
	bladeOrgans?: Uint32Array;
	/** The derived string, where it was asked for. */
	string?: string;
}

/** @param specimen that it was asked for */
export function readGrammarPlant(answer: Answer, { areas }: WithAreas = {}): GrammarPlant {
	const { columns } = answer;
	const plant = readPlant(answer);
	const marks = (of: string): Marks =>
		columns.has(`${of}.module`)
			? { module: columns.uint32(`${of}.module`), colour: columns.uint8(`${of}.colour`) }
			: { module: new Uint32Array(0), colour: new Uint8Array(0) };
	const coloured = plant.meshes.filter(({ name }) => columns.has(`mesh.${name}.colour`));
	return {
		...plant,
		lines: marks("segments"),
		organMarks: marks("organs"),
		runColours: Object.fromEntries(coloured.map(({ name }) => [name, columns.uint8(`mesh.${name}.colour`)])),
		...(areas ? { areas } : {}),
		...(columns.has("segments.area")
			? { belongs: { area: columns.uint8("segments.area"), main: columns.uint8("segments.main") } }
			: {}),
		...(columns.has("mesh.blades.organ") ? { bladeOrgans: columns.uint32("mesh.blades.organ") } : {}),
		...(columns.has("areas.volume")
			? { areaMeasures: { volume: columns.floats("areas.volume"), clothed: columns.floats("areas.clothed") } }
			: {}),
		...(columns.has("string") ? { string: columns.text("string") } : {}),
	};
}
