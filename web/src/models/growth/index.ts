/** Trees by divisor functions (Kim, Kim and Cho 2013): docs/models/growth/growth.md. */
import { titleForOwnText } from "../../specimen/preset_texts";
import type { PageModel } from "../page_model";
import { GROWTH_FORMATS } from "./formats";
import { fetchLeafOf, type GrowthPlant, readGrowthPlant } from "./growth_plant";
import { growthLevels } from "./levels";
import { growthParts } from "./parts";
import { growthRecord } from "./record";
import { encodeGrowth } from "./request";
import { GROWTH } from "./schema";
import type { GrowthSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";
import { growthInWords } from "./words";

export const model = {
	...GROWTH,
	title: "Growth",
	shelf: "Growth grammars",
	preview: true,
	noun: "tree",
	wasm: "growth.wasm",
	prepare: async (specimen) => {
		await Promise.all([fetchLeafOf(specimen), ...(specimen.grammar === undefined ? [fetchTexts()] : [])]);
	},
	encode: encodeGrowth,
	read: readGrowthPlant,
	parts: growthParts,
	levels: growthLevels,
	titled: titleForOwnText("A growth grammar of one’s own", fetchedText),
	words: growthInWords,
	record: growthRecord,
	formats: GROWTH_FORMATS,
	ui: async () => (await import("./ui/ui")).modelUi,
} satisfies PageModel<GrowthSpecimen, GrowthPlant>;
