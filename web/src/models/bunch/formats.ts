/** File formats of a bunch besides those of every plant. */
import type { Format } from "../model";
import type { BunchPlant } from "./bunch_plant";
import type { BunchSpecimen } from "./specimen";

export const BUNCH_FORMATS: readonly Format<BunchSpecimen, BunchPlant>[] = [
	{
		key: "csv",
		title: "Berries as CSV",
		about: "One line a berry: place, size, exposure, colour, ripeness",
		suffix: "-berries.csv",
		type: "text/csv",
		make: async (grown, specimen) => (await import("./tables")).berriesCsv(grown, specimen),
	},
	{
		key: "csv-measures",
		title: "Measures as CSV",
		about: "One line a measure: value, unit, class of its OIV descriptor",
		suffix: "-measures.csv",
		type: "text/csv",
		measured: true,
		applies: ({ measures }) => measures !== undefined,
		make: async (grown, specimen) => (await import("./tables")).measuresCsv(grown, specimen),
	},
];
