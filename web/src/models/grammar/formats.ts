/** File formats of a text's plant besides those of every plant. */

import type { Format } from "../model";
import type { GrammarPlant } from "./grammar_plant";
import { text } from "./messages.generated";
import type { GrammarSpecimen } from "./specimen";

export const GRAMMAR_FORMATS: readonly Format<GrammarSpecimen, GrammarPlant>[] = [
	{
		key: "lsys",
		get title() {
			return text("format");
		},
		get about() {
			return text("format_about");
		},
		suffix: ".lsys",
		type: "text/plain",
		make: async (_, specimen) => (await import("./written_text")).writtenText(specimen),
	},
];
