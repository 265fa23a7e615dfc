/** Trees by divisor functions (Kim, Kim and Cho 2013): docs/models/growth/growth.md. */

import { titleForOwnText } from "../../specimen/preset_texts";
import type { PageModel } from "../page_model";
import { GROWTH_FORMATS } from "./formats";
import { fetchLeafOf, type GrowthPlant, readGrowthPlant } from "./growth_plant";
import { growthLevels } from "./levels";
import { text } from "./messages.generated";
import { growthParts } from "./parts";
import { growthRecord } from "./record";
import { encodeGrowth } from "./request";
import { GROWTH } from "./schema";
import type { GrowthSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";
import { growthInWords } from "./words";

export const model = {
	...GROWTH,
	get title() {
		return text("title");
	},
	get shelf() {
		return text("shelf");
	},
	preview: true,
	outdoors: true,
	plantName: "tree",
	wasm: "growth.wasm",
	prepare: async (specimen) => {
		await Promise.all([fetchLeafOf(specimen), ...(specimen.grammar === undefined ? [fetchTexts()] : [])]);
	},
	encode: encodeGrowth,
	read: readGrowthPlant,
	parts: growthParts,
	levels: growthLevels,
	titled: (specimen) => titleForOwnText(text("own_title"), fetchedText)(specimen),
	summary: growthInWords,
	record: growthRecord,
	formats: GROWTH_FORMATS,
	render: async () => (await import("./growth_renderer")).growthRenderer,
	ui: async () => (await import("./ui/ui")).modelUi,
} satisfies PageModel<GrowthSpecimen, GrowthPlant>;
