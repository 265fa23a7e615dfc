import type { GrammarSource } from "../../../grammar_editor/source";
import type { GrowthSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { GROWTH_LANGUAGE } from "./language";

/** Source of a tree's text for the editor. */
export const source: GrammarSource<GrowthSpecimen> = {
	plantName: "tree",
	dialect: GROWTH_LANGUAGE,
	constants: false,
	builtIn: ({ preset }) => fetchedText({ preset }) ?? fetchTexts(),
};
