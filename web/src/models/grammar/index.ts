/** Any text grown as a plant: docs/models/grammar/grammar.md. */

import type { PageModel } from "../page_model";
import { GRAMMAR_FORMATS } from "./formats";
import { type GrammarPlant, readGrammarPlant } from "./grammar_plant";
import { text } from "./messages.generated";
import { grammarParts } from "./parts";
import { grammarRecord } from "./record";
import { encodeGrammar } from "./request";
import { GRAMMAR } from "./schema";
import type { GrammarSpecimen } from "./specimen";
import { fetchTexts } from "./texts";
import { grammarInWords, titleOfText } from "./words";

export const model = {
	...GRAMMAR,
	get title() {
		return text("title");
	},
	get shelf() {
		return text("shelf");
	},
	plantName: "plant",
	wasm: "grammar.wasm",
	strings: true,
	prepare: ({ grammar }) => (grammar === undefined ? fetchTexts() : undefined),
	traces: true,
	encode: encodeGrammar,
	read: readGrammarPlant,
	parts: grammarParts,
	titled: ({ grammar }) => (grammar === undefined ? undefined : titleOfText(grammar)),
	summary: grammarInWords,
	record: grammarRecord,
	handles: async () => (await import("./areas/area_handles")).areaHandlesOf,
	ui: async () => (await import("./ui/ui")).modelUi,
	formats: GRAMMAR_FORMATS,
} satisfies PageModel<GrammarSpecimen, GrammarPlant>;
