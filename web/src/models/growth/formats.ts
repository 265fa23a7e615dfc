/** File formats of a tree besides those of every plant. */

import { writeTextFile } from "../../specimen/text_file";
import type { Format } from "../model";
import type { GrowthPlant } from "./growth_plant";
import { text } from "./messages.generated";
import { GROWTH } from "./schema";
import type { GrowthSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";

export const GROWTH_FORMATS: readonly Format<GrowthSpecimen, GrowthPlant>[] = [
	{
		key: "growth",
		get title() {
			return text("format");
		},
		get about() {
			return text("format_about");
		},
		suffix: ".growth",
		type: "text/plain",
		make: async (_, specimen) => {
			if (specimen.grammar === undefined) await fetchTexts();
			return writeTextFile(GROWTH, specimen, fetchedText(specimen) ?? "");
		},
	},
];
