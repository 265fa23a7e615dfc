import type { GrammarSource } from "../../../grammar_editor/source";
import { fromPreset } from "../../../specimen/from_preset";
import type { GrammarPlant } from "../grammar_plant";
import { GRAMMAR } from "../schema";
import type { GrammarSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { warningsOf } from "./warnings";

/** Source of a text for the editor. */
export const source: GrammarSource<GrammarSpecimen> = {
	plantName: "plant",
	group: "lines",
	always: true,
	basics: () => 2,
	warnings: (grown, specimen) => warningsOf(grown as GrammarPlant, specimen),
	builtIn: ({ preset }) => fetchedText({ preset }) ?? fetchTexts(),
	presetConstants: (preset) => fromPreset(GRAMMAR, preset).constants,
};
