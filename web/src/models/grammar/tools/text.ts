import { withConstants } from "../../../controls/grammar/outline";
import type { GrammarSource } from "../../../controls/grammar/source";
import { fromPreset } from "../../../specimen/from_preset";
import { GRAMMAR } from "../species";
import type { GrammarSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";

const constantsOf = (preset: string) => fromPreset(GRAMMAR, preset).constants;

/** A preset's text with the values that the document gives to its constants; of a document with a text of its own, the preset's own values. */
export const source: GrammarSource<GrammarSpecimen> = {
	noun: "plant",
	group: "lines",
	always: true,
	builtIn({ preset, grammar, constants }) {
		const text = fetchedText({ preset, grammar: undefined });
		return text === undefined
			? fetchTexts()
			: withConstants(text, grammar === undefined ? constants : constantsOf(preset));
	},
	// A text of one's own says its values itself.
	details(text, { preset, grammar, constants }) {
		if (text !== undefined) return { grammar: text, constants: {} };
		return { grammar: undefined, constants: grammar === undefined ? constants : constantsOf(preset) };
	},
};
