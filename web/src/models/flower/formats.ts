/**
 * File formats of a flower besides those of every plant: its grammar, as text and as the XML of Petrenko's Table 4.
 */

import type { Format } from "../model";
import type { FlowerPlant } from "./flower_plant";
import { text } from "./messages.generated";
import { volumesTable } from "./record";
import type { FlowerSpecimen } from "./specimen";

export const FLOWER_FORMATS: readonly Format<FlowerSpecimen, FlowerPlant>[] = [
	{
		key: "gl3",
		get title() {
			return text("format");
		},
		get about() {
			return text("format_about");
		},
		suffix: ".gl3",
		type: "text/plain",
		make: async (_, specimen) => (await import("./written_text")).fileText(specimen),
	},
	{
		key: "xml",
		get title() {
			return text("format_xml");
		},
		get about() {
			return text("format_xml_about");
		},
		suffix: ".xml",
		type: "application/xml",
		make: async (_, specimen) => {
			const [{ fileText }, { xmlOf }] = await Promise.all([import("./written_text"), import("./xml/write")]);
			return xmlOf(await fileText(specimen));
		},
	},
	{
		key: "csv",
		get title() {
			return text("format_csv");
		},
		get about() {
			return text("format_csv_about");
		},
		suffix: ".csv",
		type: "text/csv",
		make: async (grown) => volumesTable(grown),
	},
];
