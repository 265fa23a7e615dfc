/** Flowers from generalized maps (Petrenko 2014): docs/models/flower/flower.md. */
import { titleForOwnText } from "../../specimen/preset_texts";
import type { PageModel } from "../page_model";
import { type FlowerPlant, readFlowerPlant } from "./flower_plant";
import { FLOWER_FORMATS } from "./formats";
import { flowerLevels } from "./levels";
import { flowerParts } from "./parts";
import { flowerRecord, tooHeavy } from "./record";
import { encodeFlower } from "./request";
import { FLOWER, isXml } from "./schema";
import type { FlowerSpecimen } from "./specimen";
import { fetchedText, fetchTexts, usesAge } from "./texts";
import { flowerInWords } from "./words";

export const model = {
	...FLOWER,
	title: "Flower",
	shelf: "Flowers",
	preview: true,
	noun: "flower",
	wasm: "flower.wasm",
	prepare: ({ grammar }) => (grammar === undefined ? fetchTexts() : undefined),
	encode: encodeFlower,
	read: readFlowerPlant,
	ages: usesAge,
	parts: flowerParts,
	levels: flowerLevels,
	titled: titleForOwnText("A flower grammar of one’s own", fetchedText),
	words: flowerInWords,
	record: flowerRecord,
	heavy: tooHeavy,
	formats: FLOWER_FORMATS,
	translated: (text) =>
		isXml(text) ? import("./xml/designed").then(({ grammarOfXml }) => grammarOfXml(text)) : undefined,
	ui: async () => (await import("./ui/ui")).modelUi,
} satisfies PageModel<FlowerSpecimen, FlowerPlant>;
