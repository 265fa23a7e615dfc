/** A tree on the stage: its parts, in a view that is as large as it grows. */
import { swayOf } from "../../plant/sway";
import { partRenderer } from "../../render/part_renderer";
import { grownRoom } from "../particles/boundary/grown_room";
import { treeLay } from "./lay";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";
import { treeParts } from "./tree_parts";
import type { TreePlant } from "./tree_plant";

export const treeRenderer = partRenderer<TreeSpecimen, TreePlant>(
	treeParts,
	(specimen) => grownRoom(treeLay, TREE_TABLE, specimen),
	swayOf,
);
