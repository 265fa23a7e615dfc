/** File formats of a text's plant besides those of every plant. */
import type { Format } from "../model";
import type { GrammarPlant } from "./grammar_plant";
import type { GrammarSpecimen } from "./specimen";

export const GRAMMAR_FORMATS: readonly Format<GrammarSpecimen, GrammarPlant>[] = [
	{
		key: "lsys",
		title: "Grammar",
		about: "The text it grows from, with the values of its constants: opens here again",
		suffix: ".lsys",
		type: "text/plain",
		make: async (_, specimen) => (await import("./written_text")).writtenText(specimen),
	},
];
