/** Renders a tree, framed for its final size. */
import { footingOf } from "../../plant/footing";
import { swayOf } from "../../plant/sway";
import { standingRenderer } from "../../render/outdoor/standing_renderer";
import { grownExtent } from "../particles/boundary/grown_extent";
import { treeLayout } from "./layout";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";
import { treeParts } from "./tree_parts";
import type { TreePlant } from "./tree_plant";

export const treeRenderer = standingRenderer<TreeSpecimen, TreePlant>({
	parts: treeParts,
	footing: footingOf,
	room: (specimen) => grownExtent(treeLayout, TREE_TABLE, specimen),
	sway: swayOf,
});
