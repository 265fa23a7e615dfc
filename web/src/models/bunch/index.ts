/** The grape bunch (Huang et al. 2013): docs/bunch.md. */
import type { Model } from "../model";
import { BUNCH_FORMATS } from "./formats";
import type { Grown } from "./grown";
import { fetchLeaf } from "./leaf";
import { bunchParts } from "./parts/bunch_parts";
import { readGrown } from "./read_grown";
import { bunchRecord } from "./record";
import { encodeRequest } from "./request";
import { BUNCH, hasLeaves } from "./species";
import type { BunchSpecimen } from "./specimen";
import { bunchInWords } from "./words";

export const model = {
	...BUNCH,
	title: "Grape bunch",
	noun: "bunch",
	wasm: "bunch.wasm",
	prepare: (specimen) => (hasLeaves(specimen) ? fetchLeaf() : undefined),
	encode: encodeRequest,
	read: readGrown,
	parts: bunchParts,
	instanced: ({ procedure }) => procedure === "paper",
	words: bunchInWords,
	record: bunchRecord,
	extras: ({ procedure, plan, second }) => ({ procedure, plan: { ...plan, second } }),
	formats: BUNCH_FORMATS,
	figure: async () => (await import("./figure/bunch_figure")).bunchFigure,
	studio: async () => (await import("./tools/face")).face,
} satisfies Model<BunchSpecimen, Grown>;
