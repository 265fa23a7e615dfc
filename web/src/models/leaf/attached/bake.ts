/**
 * Bakes the leaves that are attached to other plants from this model's presets. `npm run generate -- leaves` writes
 * the files; a test compares them.
 */
import type { Core } from "../../../core/core";
import type { LeafFile } from "../../../plant/leaf";
import { outlineOf } from "../presets/presets";
import { readLeaf } from "../read_leaf";
import { encodeLeaf } from "../request";
import { leafFromPreset } from "../schema";
import type { LeafSpecimen } from "../specimen";
import { type AttachedLeafOptions, encodeAttachedLeaf } from "./attached_leaf";

interface Baked extends AttachedLeafOptions {
	/** Triangles of the blade before simplification, relative to the core's default. */
	detail: number;
	/** The preset; absent where it has the leaf's name. */
	preset?: string;
	/**
	 * An outline in place of the preset's, in the format of preset files: for leaves that differ from the preset
	 * mainly in outline.
	 */
	half?: string;
	/** Parameters in place of the preset's. */
	parameters?: LeafSpecimen["parameters"];
}

/**
 * Returns the options of a tree's leaf: with `corners` per half of the margin, and without teeth, which are smaller
 * than its few triangles.
 */
const treeLeaf = (corners: number): Baked => ({ detail: 0.25, corners, pixels: 64, parameters: { teeth: 0 } });

/** Options of the baked leaves, by name. */
const BAKED: Readonly<Record<string, Baked>> = {
	grapevine: { detail: 0.25, cells: 20, pixels: 512 },
	// Drawn until the detailed grapevine leaf has been fetched.
	grapevine_sketch: { ...treeLeaf(14), preset: "grapevine" },
	// Malus domestica: oval, widest at the middle.
	apple: {
		...treeLeaf(5),
		preset: "beech",
		half: "0 0 corner, 130 24, 262 150, 330 330, 330 500, 280 680, 176 830, 78 934, 0 1000 pointed",
	},
	beech: treeLeaf(5),
	birch: treeLeaf(6),
	lime: treeLeaf(7),
	maple: treeLeaf(11),
	oak: treeLeaf(10),
	// Olea europaea: a lance, less slender than a willow's.
	olive: {
		...treeLeaf(4),
		preset: "willow",
		half: "0 0 corner, 50 80, 100 260, 118 450, 105 650, 66 830, 28 940, 0 1000 pointed",
	},
	// Populus nigra: a triangle on a long stalk.
	poplar: {
		...treeLeaf(5),
		preset: "birch",
		half: "0 0 corner, 200 -12, 400 84, 462 200, 400 345, 262 580, 122 790, 42 920, 0 1000 pointed",
	},
	vine: { ...treeLeaf(11), preset: "grapevine" },
	willow: treeLeaf(4),
};

/** Names of the baked leaves and of their files. */
export const BAKED_LEAVES = Object.keys(BAKED);

/** Returns the specimen that a baked leaf is grown from: a preset, in some cases with another outline. */
export function bakedSpecimen(name: string): LeafSpecimen {
	const { parameters, half, preset = name } = BAKED[name];
	const base = leafFromPreset(preset);
	return {
		...base,
		parameters: { ...base.parameters, ...parameters },
		...(half ? { outline: outlineOf(half) } : {}),
	};
}

/** Grows and bakes a leaf: the same core gives the same file. */
export function bakeLeaf(core: Core, name: string): LeafFile {
	const { detail, parameters, half, preset = name, ...options } = BAKED[name];
	const specimen = bakedSpecimen(name);
	const leaf = readLeaf(core.grow(encodeLeaf(specimen, { detail, sky: false, measures: false })));
	return encodeAttachedLeaf(leaf, specimen, `leaf/${preset}`, options);
}
