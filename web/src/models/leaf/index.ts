/** The leaf from the trails of particles (Rodkaew et al. 2003): docs/models/leaf/leaf.md. */

import type { PageModel } from "../page_model";
import { trailRecord } from "../particles/record";
import { LEAF_FORMATS } from "./formats";
import type { Leaf } from "./grown";
import { text } from "./messages.generated";
import { leafParts } from "./parts/leaf_parts";
import { readLeaf } from "./read_leaf";
import { encodeLeaf } from "./request";
import { LEAF } from "./schema";
import type { LeafSpecimen } from "./specimen";
import { leafInWords } from "./words";

export const model = {
	...LEAF,
	get title() {
		return text("title");
	},
	preview: true,
	plantName: "leaf",
	wasm: "particles.wasm",
	encode: encodeLeaf,
	read: readLeaf,
	parts: (grown, specimen) => leafParts(grown, specimen),
	summary: leafInWords,
	record: trailRecord,
	formats: LEAF_FORMATS,
	render: async () => (await import("./render/leaf_renderer")).leafRenderer,
	handles: async () => (await import("./outline/plant_handles")).leafHandles,
	ui: async () => (await import("./ui/ui")).face,
} satisfies PageModel<LeafSpecimen, Leaf>;
