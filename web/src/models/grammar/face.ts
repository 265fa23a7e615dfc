/** The page's side of grammars: the text beside its plant, with sliders of its constants. */
import { html } from "lit";
import { outlineOf, withConstants } from "../../controls/grammar/outline";
import type { GrammarSource } from "../../controls/grammar/source";
import { grammarTools } from "../../controls/grammar_tool";
import type { Face } from "../../controls/tool";
import { fromPreset } from "../../specimen/from_preset";
import type { GrammarPlant } from "./grammar_plant";
import { GRAMMAR } from "./species";
import type { GrammarSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";

/** Values of constants are written into the text as soon as it is the document's own: one number, one place. */
const source: GrammarSource<GrammarSpecimen> = {
	noun: "plant",
	group: "lines",
	always: true,
	builtIn: ({ grammar, preset, constants }) => {
		const text = fetchedText({ preset });
		if (text === undefined) return fetchTexts();
		return withConstants(text, grammar === undefined ? constants : presetConstants(preset));
	},
	details: (grammar, { preset, constants }) => {
		if (grammar === undefined) return { grammar, constants: presetConstants(preset) };
		const written = new Set(outlineOf(grammar).constants.map(({ name }) => name));
		return { grammar, constants: Object.fromEntries(Object.entries(constants).filter(([name]) => !written.has(name))) };
	},
};

function presetConstants(preset: string): Readonly<Record<string, number>> {
	return fromPreset(GRAMMAR, preset).constants;
}

export const face: Face<GrammarSpecimen, GrammarPlant> = {
	tools: grammarTools(source),
	about: html`<p>Any L-system’s text grows as a plant: change it, and the plant follows.</p>`,
};
