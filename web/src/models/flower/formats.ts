/**
 * File formats of a flower besides those of every plant: its grammar, as text and as the XML of Petrenko's Table 4.
 */
import type { Format } from "../model";
import type { FlowerPlant } from "./flower_plant";
import { volumesTable } from "./record";
import type { FlowerSpecimen } from "./specimen";

export const FLOWER_FORMATS: readonly Format<FlowerSpecimen, FlowerPlant>[] = [
	{
		key: "gl3",
		title: "Grammar",
		about: "The text it grows from: opens here again",
		suffix: ".gl3",
		type: "text/plain",
		make: async (_, specimen) => (await import("./written_text")).fileText(specimen),
	},
	{
		key: "xml",
		title: "Grammar as XML",
		about: "The same in the elements of the thesis’s Table 4: opens here again",
		suffix: ".xml",
		type: "application/xml",
		make: async (_, specimen) => {
			const [{ fileText }, { xmlOf }] = await Promise.all([import("./written_text"), import("./xml/write")]);
			return xmlOf(await fileText(specimen));
		},
	},
	{
		key: "csv",
		title: "Volumes as a table",
		about: "A line for each volume: what it grew from, its name, its numbers",
		suffix: ".csv",
		type: "text/csv",
		make: async (grown) => volumesTable(grown),
	},
];
