import { outlineOf, withConstants } from "../../../controls/grammar/outline";
import type { GrammarSource } from "../../../controls/grammar/source";
import { fromPreset } from "../../../specimen/from_preset";
import type { GrammarPlant } from "../grammar_plant";
import { GRAMMAR } from "../species";
import type { GrammarSpecimen } from "../specimen";
import { fetchedText, fetchTexts } from "../texts";
import { warningsOf } from "./warnings";

/** Values of constants are written into the text as soon as it is the document's own: one number, one place. */
export const source: GrammarSource<GrammarSpecimen> = {
	noun: "plant",
	group: "lines",
	always: true,
	warnings: (grown, specimen) => warningsOf(grown as GrammarPlant, specimen),
	builtIn({ preset, grammar, constants }) {
		const text = fetchedText({ preset });
		if (text === undefined) return fetchTexts();
		return withConstants(text, grammar === undefined ? constants : constantsOf(preset));
	},
	details(text, { preset, grammar, constants }) {
		// The built-in text as it stands in the editor has the document's own values.
		if (text === undefined)
			return { grammar: text, constants: grammar === undefined ? constants : constantsOf(preset) };
		const written = new Set(outlineOf(text).constants.map(({ name }) => name));
		const given = Object.entries(constants).filter(([name]) => !written.has(name));
		return { grammar: text, constants: Object.fromEntries(given) };
	},
};

function constantsOf(preset: string): Readonly<Record<string, number>> {
	return fromPreset(GRAMMAR, preset).constants;
}
