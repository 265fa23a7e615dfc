/** Any text grown as a plant: docs/models/grammar/grammar.md. */
import type { Model } from "../model";
import { type GrammarPlant, readGrammarPlant } from "./grammar_plant";
import { grammarParts } from "./parts";
import { grammarRecord } from "./record";
import { encodeGrammar } from "./request";
import { GRAMMAR } from "./species";
import type { GrammarSpecimen } from "./specimen";
import { fetchTexts } from "./texts";
import { grammarInWords } from "./words";

export const model = {
	...GRAMMAR,
	title: "Grammar",
	preview: true,
	noun: "plant",
	wasm: "grammar.wasm",
	pictures: false,
	prepare: ({ grammar }) => (grammar === undefined ? fetchTexts() : undefined),
	encode: encodeGrammar,
	read: readGrammarPlant,
	parts: grammarParts,
	words: grammarInWords,
	record: grammarRecord,
	handles: async () => (await import("./areas/area_handles")).areaHandlesOf,
	studio: async () => (await import("./tools/face")).face,
} satisfies Model<GrammarSpecimen, GrammarPlant>;
