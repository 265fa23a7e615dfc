import type { GrammarSource } from "../../../grammar_editor/source";
import { fromPreset } from "../../../specimen/from_preset";
import { FLOWER } from "../schema";
import type { FlowerSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { FLOWER_LANGUAGE } from "./language";

/** Where a flower's text comes from. */
export const source: GrammarSource<FlowerSpecimen> = {
	noun: "flower",
	dialect: FLOWER_LANGUAGE,
	always: true,
	// It is no variable: the parameter of the steps stands for it.
	governed: new Set(["finalStep"]),
	leans: "bend",
	builtIn: ({ preset }) => fetchedText({ preset }) ?? fetchTexts(),
	presetConstants: (preset) => fromPreset(FLOWER, preset).constants,
};
