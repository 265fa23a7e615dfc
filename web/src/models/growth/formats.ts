/** File formats of a tree besides those of every plant. */
import { writeTextFile } from "../../specimen/text_file";
import type { Format } from "../model";
import type { GrowthPlant } from "./growth_plant";
import { GROWTH } from "./schema";
import type { GrowthSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";

export const GROWTH_FORMATS: readonly Format<GrowthSpecimen, GrowthPlant>[] = [
	{
		key: "growth",
		title: "Grammar",
		about: "The text it grows from, with its parameters in the first line: opens here again",
		suffix: ".growth",
		type: "text/plain",
		make: async (_, specimen) => {
			if (specimen.grammar === undefined) await fetchTexts();
			return writeTextFile(GROWTH, specimen, fetchedText(specimen) ?? "");
		},
	},
];
