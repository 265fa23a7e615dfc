/** Renders a tree, framed for its final size. */
import { swayOf } from "../../plant/sway";
import { partRenderer } from "../../render/part_renderer";
import { grownExtent } from "../particles/boundary/grown_extent";
import { treeLayout } from "./layout";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";
import { treeParts } from "./tree_parts";
import type { TreePlant } from "./tree_plant";

export const treeRenderer = partRenderer<TreeSpecimen, TreePlant>(
	treeParts,
	(specimen) => grownExtent(treeLayout, TREE_TABLE, specimen),
	swayOf,
);
