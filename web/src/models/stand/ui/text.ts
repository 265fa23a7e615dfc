import type { GrammarSource } from "../../../grammar_editor/source";
import type { StandSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { STAND_LANGUAGE } from "./language";

/** Source of a stand's plan for the editor. */
export const source: GrammarSource<StandSpecimen> = {
	plantName: "stand",
	dialect: STAND_LANGUAGE,
	constants: false,
	builtIn: ({ preset }) => fetchedText({ preset }) ?? fetchTexts(),
};
