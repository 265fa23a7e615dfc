/** Converts an answer's columns to a text's plant (wasm-core/src/models/grammar/model.hpp). */
import type { Answer } from "../../core/core";
import type { Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";
import type { Area, WithAreas } from "./areas/area";

/** Attributes of segments or organs, one value each. */
export interface Marks {
	/** Module that drew it, by its place in the last string, from 0. */
	module: Uint32Array;
	/** Colour of the palette, 1 … 8. */
	colour: Uint8Array;
}

/** A plant grown from a text. */
export interface GrammarPlant extends Plant {
	/** Attributes of segments. */
	lines: Marks;
	/** Attributes of organs. */
	organMarks: Marks;
	/**
	 * For segments, if the text uses areas: the growth area of each, from 1, 0 for none, and whether it belongs to the
	 * main branch.
	 */
	belongs?: { area: Uint8Array; main: Uint8Array };
	/** Growth areas that it has grown in, if any. */
	areas?: readonly Area[];
	/** Measures of growth areas, if requested: volume in m³, and the share of the surface that leaves cover. */
	areaMeasures?: { volume: Float32Array; clothed: Float32Array };
	/** Colours of each mesh's runs, by the mesh's name. */
	runColours: Readonly<Record<string, Uint8Array>>;
	/** Organ of each run of the mesh `blades`, if known. */
	bladeOrgans?: Uint32Array;
	/** The derived string, if requested. */
	string?: string;
}

/**
 * Reads a plant from an answer.
 * @param specimen the requested specimen
 */
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
