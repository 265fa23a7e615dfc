/** The model of trees from the trails of particles (Rodkaew et al. 2003, section 4): docs/models/tree/tree.md. */

import { leafBlocks } from "../../plant/leaf";
import type { PageModel } from "../page_model";
import { boundedBy } from "../particles/boundary/mesh_boundary";
import { encodeBounded } from "../particles/boundary/request";
import { woodFormats } from "../particles/boundary/wood_formats";
import { trailRecord } from "../particles/record";
import { text } from "./messages.generated";
import { TREE } from "./schema";
import type { TreeSpecimen } from "./specimen";
import { treeParts } from "./tree_parts";
import { fetchLeafOf, leafOf, readTree, type TreePlant } from "./tree_plant";
import { treeInWords } from "./words";

export const model = {
	...TREE,
	get title() {
		return text("title");
	},
	get shelf() {
		return text("shelf");
	},
	preview: true,
	outdoors: true,
	plantName: "tree",
	wasm: "particles.wasm",
	prepare: fetchLeafOf,
	bounded: (specimen, file) => boundedBy(TREE, specimen, file, "height"),
	encode: (specimen, options) => {
		const leaf = leafOf(specimen);
		return [
			...encodeBounded(TREE.table, specimen, { light: !options?.preview, ...options }),
			...(leaf ? leafBlocks(leaf) : []),
		];
	},
	read: readTree,
	parts: treeParts,
	summary: treeInWords,
	record: trailRecord,
	formats: woodFormats(treeInWords),
	render: async () => (await import("./tree_renderer")).treeRenderer,
	handles: async () => (await import("./plant_handles")).treeHandles,
	ui: async () => (await import("./ui/ui")).face,
} satisfies PageModel<TreeSpecimen, TreePlant>;
