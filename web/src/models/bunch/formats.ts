/** File formats of a bunch besides those of every plant. */

import type { Format } from "../model";
import type { BunchPlant } from "./bunch_plant";
import { text } from "./messages.generated";
import type { BunchSpecimen } from "./specimen";

export const BUNCH_FORMATS: readonly Format<BunchSpecimen, BunchPlant>[] = [
	{
		key: "csv",
		get title() {
			return text("format_berries");
		},
		get about() {
			return text("format_berries_about");
		},
		suffix: "-berries.csv",
		type: "text/csv",
		make: async (grown, specimen) => (await import("./tables")).berriesCsv(grown, specimen),
	},
	{
		key: "csv-measures",
		get title() {
			return text("format_measures");
		},
		get about() {
			return text("format_measures_about");
		},
		suffix: "-measures.csv",
		type: "text/csv",
		measured: true,
		applies: ({ measures }) => measures !== undefined,
		make: async (grown, specimen) => (await import("./tables")).measuresCsv(grown, specimen),
	},
];
