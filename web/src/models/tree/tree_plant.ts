/** A tree as it came back, with the veins of the leaf that it bears. */
import type { Answer } from "../../core/core";
import type { AttachedLeaf, Veins } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";
import { readWoodenPlant, type WoodenPlant } from "../particles/boundary/wooden_plant";
import { type LightGrid, readLight } from "./light/light_grid";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";

export interface TreePlant extends WoodenPlant {
	/** Of every leaf, over its texture coordinates; absent where it has none. */
	veins?: Veins;
	/** The light in its crown; absent where it was not asked for. */
	light?: LightGrid;
}

const kindOf = (specimen: TreeSpecimen): string => TREE_TABLE.option(specimen, "leaf_kind") ?? "";

/** Fetches the leaf that a tree bears; needles are not baked. */
export function fetchLeafOf(specimen: TreeSpecimen): Promise<void> | undefined {
	return specimen.parameters.leaves > 0 ? fetchBakedLeaf(kindOf(specimen)) : undefined;
}

/** Undefined before it is there, and of needles. */
export const leafOf = (specimen: TreeSpecimen): AttachedLeaf | undefined => fetchedLeaf(kindOf(specimen));

export function readTree(answer: Answer, specimen: TreeSpecimen): TreePlant {
	const { veins } = leafOf(specimen) ?? {};
	const light = readLight(answer);
	return { ...readWoodenPlant(answer), ...(veins ? { veins } : {}), ...(light ? { light } : {}) };
}
