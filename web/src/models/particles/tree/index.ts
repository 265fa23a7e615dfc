/** The tree of particles' trails (Rodkaew et al. 2003, section 4): docs/models/tree/tree.md. */
import type { Model } from "../../model";
import { encodeBounded } from "../boundary/request";
import { readWoodenPlant, type WoodenPlant } from "../boundary/wooden_plant";
import { trailRecord } from "../record";
import { TREE } from "./species";
import type { TreeSpecimen } from "./specimen";
import { treeParts } from "./tree_parts";
import { treeInWords } from "./words";

export const model = {
	...TREE,
	title: "Tree",
	noun: "tree",
	wasm: "particles.wasm",
	encode: (specimen, options) => encodeBounded(TREE.table, specimen, options),
	read: readWoodenPlant,
	parts: treeParts,
	words: treeInWords,
	record: trailRecord,
	studio: async () => (await import("./tools/face")).face,
} satisfies Model<TreeSpecimen, WoodenPlant>;
