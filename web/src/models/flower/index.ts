/** Flowers from generalized maps (Petrenko 2014): docs/models/flower/flower.md. */

import { titleForOwnText } from "../../specimen/preset_texts";
import type { PageModel } from "../page_model";
import { type FlowerPlant, readFlowerPlant } from "./flower_plant";
import { FLOWER_FORMATS } from "./formats";
import { flowerLevels } from "./levels";
import { text as message } from "./messages.generated";
import { flowerParts } from "./parts";
import { flowerRecord, tooHeavy } from "./record";
import { encodeFlower } from "./request";
import { FLOWER, isXml } from "./schema";
import type { FlowerSpecimen } from "./specimen";
import { fetchedText, fetchTexts, usesAge } from "./texts";
import { flowerInWords } from "./words";

export const model = {
	...FLOWER,
	get title() {
		return message("title");
	},
	get shelf() {
		return message("shelf");
	},
	preview: true,
	plantName: "flower",
	wasm: "flower.wasm",
	prepare: ({ grammar }) => (grammar === undefined ? fetchTexts() : undefined),
	encode: encodeFlower,
	read: readFlowerPlant,
	ages: usesAge,
	parts: flowerParts,
	levels: flowerLevels,
	titled: (specimen) => titleForOwnText(message("own_title"), fetchedText)(specimen),
	summary: flowerInWords,
	record: flowerRecord,
	heavy: tooHeavy,
	formats: FLOWER_FORMATS,
	translated: (text) =>
		isXml(text) ? import("./xml/designed").then(({ grammarOfXml }) => grammarOfXml(text)) : undefined,
	ui: async () => (await import("./ui/ui")).modelUi,
} satisfies PageModel<FlowerSpecimen, FlowerPlant>;
