/** The page's model of the grape bunch (Huang et al. 2013): docs/bunch.md. */

import type { PageModel } from "../page_model";
import type { BunchPlant } from "./bunch_plant";
import { BUNCH_FORMATS } from "./formats";
import { fetchLeaf, fetchSketch } from "./leaf";
import { SKIN, skinClass } from "./measures";
import { text } from "./messages.generated";
import { ownTextNotes } from "./own_text";
import { bunchParts } from "./parts/bunch_parts";
import { BUNCH_LABELS } from "./parts/point_labels";
import { readBunchPlant } from "./read_bunch_plant";
import { bunchRecord } from "./record";
import { encodeRequest } from "./request";
import { BUNCH, hasLeaves } from "./schema";
import type { BunchSpecimen } from "./specimen";
import { bunchTargets } from "./targets";
import { bunchInWords } from "./words";

export const model = {
	...BUNCH,
	get title() {
		return text("title");
	},
	plantName: "bunch",
	wasm: "bunch.wasm",
	prepare: (specimen) => (hasLeaves(specimen) ? fetchLeaf() : undefined),
	sketch: (specimen) => (hasLeaves(specimen) ? fetchSketch() : undefined),
	traces: true,
	encode: encodeRequest,
	read: (answer, specimen) => {
		const grown = readBunchPlant(answer);
		return { ...grown, notes: [...grown.notes, ...ownTextNotes(specimen)] };
	},
	parts: bunchParts,
	instanced: () => true,
	summary: bunchInWords,
	record: bunchRecord,
	descriptors: [{ ...SKIN, classOf: ({ look }) => skinClass(look) }],
	labels: BUNCH_LABELS,
	extras: ({ procedure, plan, second }) => ({ procedure, plan: { ...plan, second } }),
	formats: BUNCH_FORMATS,
	targets: bunchTargets,
	render: async () => (await import("./render/bunch_renderer")).bunchRenderer,
	handles: async () => (await import("./profile/plant_handles")).bunchHandles,
	ui: async () => (await import("./ui/ui")).modelUi,
} satisfies PageModel<BunchSpecimen, BunchPlant>;
