/** The leaves that other plants bear, baked from this model's presets: what `npm run generate -- leaves` writes and a test compares. */
import type { Core } from "../../../core/core";
import type { LeafFile } from "../../../plant/leaf";
import { outlineOf } from "../presets/presets";
import { readLeaf } from "../read_leaf";
import { encodeLeaf } from "../request";
import { leafFromPreset } from "../schema";
import type { LeafSpecimen } from "../specimen";
import { type AttachedLeafOptions, encodeAttachedLeaf } from "./attached_leaf";

interface Baked extends AttachedLeafOptions {
	/** Triangles of the blade before it is made light, against the core's own choice. */
	detail: number;
	/** Its preset; absent where that is its name. */
	preset?: string;
	/** An outline in place of the preset's own, as preset files have it: of leaves that differ from it in little else. */
	half?: string;
	/** In place of the preset's own. */
	parameters?: LeafSpecimen["parameters"];
}

/** As trees bear it: teeth are finer than its few triangles. */
const onTree = (corners: number): Baked => ({ detail: 0.25, corners, pixels: 64, parameters: { teeth: 0 } });

/** By name. */
const BAKED: Readonly<Record<string, Baked>> = {
	grapevine: { detail: 0.25, cells: 20, pixels: 512 },
	// What a first picture shows while that is on its way.
	grapevine_sketch: { ...onTree(14), preset: "grapevine" },
	// Malus domestica: oval, widest at the middle.
	apple: {
		...onTree(5),
		preset: "beech",
		half: "0 0 corner, 130 24, 262 150, 330 330, 330 500, 280 680, 176 830, 78 934, 0 1000 pointed",
	},
	beech: onTree(5),
	birch: onTree(6),
	lime: onTree(7),
	maple: onTree(11),
	oak: onTree(10),
	// Olea europaea: a lance, less slender than a willow's.
	olive: {
		...onTree(4),
		preset: "willow",
		half: "0 0 corner, 50 80, 100 260, 118 450, 105 650, 66 830, 28 940, 0 1000 pointed",
	},
	// Populus nigra: a triangle on a long stalk.
	poplar: {
		...onTree(5),
		preset: "birch",
		half: "0 0 corner, 200 -12, 400 84, 462 200, 400 345, 262 580, 122 790, 42 920, 0 1000 pointed",
	},
	vine: { ...onTree(11), preset: "grapevine" },
	willow: onTree(4),
};

/** Their names, which are those of the files. */
export const BAKED_LEAVES = Object.keys(BAKED);

/** What is grown for it: a preset, or one with an outline of its own. */
export function bakedSpecimen(name: string): LeafSpecimen {
	const { parameters, half, preset = name } = BAKED[name];
	const own = leafFromPreset(preset);
	return {
		...own,
		parameters: { ...own.parameters, ...parameters },
		...(half ? { outline: outlineOf(half) } : {}),
	};
}

/** Grows a preset and bakes it: the same core gives the same file. */
export function bakeLeaf(core: Core, name: string): LeafFile {
	const { detail, parameters, half, preset = name, ...options } = BAKED[name];
	const specimen = bakedSpecimen(name);
	const leaf = readLeaf(core.grow(encodeLeaf(specimen, { detail, sky: false, measures: false })));
	return encodeAttachedLeaf(leaf, specimen, `leaf/${preset}`, options);
}
