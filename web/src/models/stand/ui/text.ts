import type { GrammarSource } from "../../../grammar_editor/source";
import type { StandSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { STAND_LANGUAGE } from "./language";

/** Where a stand's plan comes from. */
export const source: GrammarSource<StandSpecimen> = {
	noun: "stand",
	dialect: STAND_LANGUAGE,
	constants: false,
	builtIn: ({ preset }) => fetchedText({ preset }) ?? fetchTexts(),
};
