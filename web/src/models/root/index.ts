/** The model of roots from the trails of particles (Rodkaew et al. 2003, section 4): docs/models/root/root.md. */

import type { PageModel } from "../page_model";
import { boundedBy } from "../particles/boundary/mesh_boundary";
import { encodeBounded } from "../particles/boundary/request";
import { woodFormats } from "../particles/boundary/wood_formats";
import { readWoodenPlant, type WoodenPlant } from "../particles/boundary/wooden_plant";
import { trailRecord } from "../particles/record";
import { text } from "./messages.generated";
import { rootParts } from "./root_parts";
import { ROOT } from "./schema";
import type { RootSpecimen } from "./specimen";
import { rootInWords } from "./words";

export const model = {
	...ROOT,
	get title() {
		return text("title");
	},
	preview: true,
	still: true,
	plantName: "root",
	wasm: "particles.wasm",
	bounded: (specimen, file) => boundedBy(ROOT, specimen, file, "reach"),
	encode: (specimen, options) => encodeBounded(ROOT.table, specimen, options),
	read: readWoodenPlant,
	parts: rootParts,
	summary: rootInWords,
	record: trailRecord,
	formats: woodFormats(rootInWords),
	render: async () => (await import("./cut_renderer")).cutRenderer,
	handles: async () => (await import("./plant_handles")).rootHandles,
	ui: async () => (await import("./ui/ui")).face,
} satisfies PageModel<RootSpecimen, WoodenPlant>;
