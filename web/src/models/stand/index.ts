/** The model of stands of many plants on a ground: docs/models/stand/stand.md. */

import { titleForOwnText } from "../../specimen/preset_texts";
import { writeTextFile } from "../../specimen/text_file";
import type { PageModel } from "../page_model";
import { fetchSoil } from "./fetched_soil";
import { standMembers } from "./members";
import { text } from "./messages.generated";
import { standParts } from "./parts";
import { placementsCsv, standRecord } from "./record";
import { encodeStand } from "./request";
import { STAND } from "./schema";
import type { StandSpecimen } from "./specimen";
import { readStand, type StandPlant } from "./stand_plant";
import { fetchedText, fetchTexts } from "./texts";
import { standInWords } from "./words";

export const model = {
	...STAND,
	get title() {
		return text("title");
	},
	get shelf() {
		return text("shelf");
	},
	preview: true,
	outdoors: true,
	plantName: "stand",
	wasm: "stand.wasm",
	prepare: ({ grammar }) => {
		const soil = fetchSoil();
		return grammar === undefined ? Promise.all([fetchTexts(), soil]).then(() => {}) : soil;
	},
	encode: encodeStand,
	read: readStand,
	members: standMembers,
	// The view animates its plants; a file with thousands of animated plants would be too large.
	still: "in files",
	parts: standParts,
	instanced: ({ members, memberOf }) => members.length < memberOf.length,
	titled: (specimen) => titleForOwnText(text("own_title"), fetchedText)(specimen),
	summary: standInWords,
	record: standRecord,
	formats: [
		{
			key: "csv",
			get title() {
				return text("format_csv");
			},
			get about() {
				return text("format_csv_about");
			},
			suffix: "-plants.csv",
			type: "text/csv",
			make: async (grown, specimen) => placementsCsv(grown, specimen),
		},
		{
			key: "stand",
			get title() {
				return text("format_plan");
			},
			get about() {
				return text("format_plan_about");
			},
			suffix: ".stand",
			type: "text/plain",
			make: async (_, specimen) => {
				if (specimen.grammar === undefined) await fetchTexts();
				return writeTextFile(STAND, specimen, fetchedText(specimen) ?? "");
			},
		},
	],
	render: async () => {
		const { StandRenderer } = await import("./render/stand_renderer");
		return (stage) => new StandRenderer(stage);
	},
	ui: async () => (await import("./ui/ui")).face,
} satisfies PageModel<StandSpecimen, StandPlant>;
