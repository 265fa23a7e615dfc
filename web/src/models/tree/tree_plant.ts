/** A grown tree, with the veins of the leaf that is attached to it. */
import type { Answer } from "../../core/core";
import type { AttachedLeaf, Veins } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";
import { readWoodenPlant, type WoodenPlant } from "../particles/boundary/wooden_plant";
import { type LightGrid, readLight } from "./light/light_grid";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";

export interface TreePlant extends WoodenPlant {
	/** Veins of all leaves, over their texture coordinates; absent where there are none. */
	veins?: Veins;
	/** The light in the crown; absent where not requested. */
	light?: LightGrid;
}

/** Returns the key of a tree's kind of leaf; empty where there is none. */
const leafKind = (specimen: TreeSpecimen): string => TREE_TABLE.option(specimen, "leaf_kind") ?? "";

/** Fetches the leaf of a tree; needles are not baked. */
export function fetchLeafOf(specimen: TreeSpecimen): Promise<void> | undefined {
	return specimen.parameters.leaves > 0 ? fetchBakedLeaf(leafKind(specimen)) : undefined;
}

/** Returns the leaf of a tree; undefined before it is fetched, and for needles. */
export const leafOf = (specimen: TreeSpecimen): AttachedLeaf | undefined => fetchedLeaf(leafKind(specimen));

/**
 * Reads a tree from the core's answer, with the veins of its leaf and the light in its crown where they are known.
 */
export function readTree(answer: Answer, specimen: TreeSpecimen): TreePlant {
	const { veins } = leafOf(specimen) ?? {};
	const light = readLight(answer);
	return { ...readWoodenPlant(answer), ...(veins ? { veins } : {}), ...(light ? { light } : {}) };
}
