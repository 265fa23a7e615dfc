import type { GrammarSource } from "../../../grammar_editor/source";
import { fromPreset } from "../../../specimen/from_preset";
import { FLOWER } from "../schema";
import type { FlowerSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { FLOWER_LANGUAGE } from "./language";

/** Source of a flower's text for the editor. */
export const source: GrammarSource<FlowerSpecimen> = {
	plantName: "flower",
	dialect: FLOWER_LANGUAGE,
	always: true,
	// The parameter `steps` controls it; it is not a variable.
	governed: new Set(["finalStep"]),
	leans: "bend",
	builtIn: ({ preset }) => fetchedText({ preset }) ?? fetchTexts(),
	presetConstants: (preset) => fromPreset(FLOWER, preset).constants,
};
