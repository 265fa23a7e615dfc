/**
 * Compares each translation (web/src/locale/<language>.json) with the English texts. `npm run generate -- translation` sets
 * PANICLE_TRANSLATE, which writes the file instead: keys in the order of the English ones, missing ones in English.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { argumentsOf, type Part, readMessage } from "../../../wasm-core/tools/generate/icu.mjs";
import { translations } from "../../../wasm-core/tools/generate/messages.mjs";
import { englishTexts, type TextsByRoom } from "./english";

const english = await englishTexts();
const isWriting = process.env.PANICLE_TRANSLATE !== undefined;

/** Keys of all rooms with their rooms. */
const codesOf = (rooms: TextsByRoom): string[] =>
	Object.entries(rooms).flatMap(([room, texts]) => Object.keys(texts).map((key) => `${room}.${key}`));

/** Texts in tables and presets hold no arguments. */
const hasArguments = (room: string): boolean => !/^(parameters|measures|presets)\./.test(room);

const namesIn = (room: string, text: string): string[] =>
	hasArguments(room) ? [...argumentsOf(readMessage(text)).keys()].sort() : [];

describe.each(translations())("%s", (name) => {
	const file = `web/src/locale/${name}`;
	const translation: TextsByRoom = JSON.parse(readFileSync(file, "utf8"));
	if (isWriting) {
		const merged = Object.entries(english).map(([room, texts]) => [
			room,
			Object.fromEntries(Object.entries(texts).map(([key, text]) => [key, translation[room]?.[key] ?? text])),
		]);
		writeFileSync(file, `${JSON.stringify(Object.fromEntries(merged), null, "\t")}\n`);
	}

	it.skipIf(isWriting)("has every text of the page, the core, the tables and the presets, and no other", () => {
		const [own, all] = [new Set(codesOf(translation)), new Set(codesOf(english))];
		expect([...all].filter((code) => !own.has(code))).toEqual([]);
		expect([...own].filter((code) => !all.has(code))).toEqual([]);
	});

	it.skipIf(isWriting)("uses the arguments of the English texts", () => {
		const wrong = Object.entries(english).flatMap(([room, texts]) =>
			Object.entries(texts)
				.filter(([key, text]) => {
					const translated = translation[room]?.[key];
					return translated !== undefined && `${namesIn(room, translated)}` !== `${namesIn(room, text)}`;
				})
				.map(([key]) => `${room}.${key}`),
		);
		expect(wrong).toEqual([]);
	});
});

/** Number of words of a text without its arguments; of the cases of a plural or select, those of “other” count. */
function wordsIn(room: string, text: string): number {
	const literal = (parts: readonly Part[]): string =>
		parts.map((part) => (typeof part === "string" ? part : "cases" in part ? literal(part.cases.other) : " ")).join("");
	const words = hasArguments(room) ? literal(readMessage(text)) : text;
	return words.match(/\p{L}+/gu)?.length ?? 0;
}

/** Texts of three words or more that are the same in French and English, by room and key, and why. */
const SAME_IN_FRENCH: Record<string, string> = {};

describe("fr.json", () => {
	const french: TextsByRoom = JSON.parse(readFileSync("web/src/locale/fr.json", "utf8"));

	it("has no English text of three words or more, save those that are the same in French", () => {
		const same = Object.entries(english).flatMap(([room, texts]) =>
			Object.entries(texts)
				.filter(([key, text]) => french[room]?.[key] === text && wordsIn(room, text) >= 3)
				.map(([key]) => `${room}.${key}`),
		);
		expect(same.sort()).toEqual(Object.keys(SAME_IN_FRENCH).sort());
	});

	it("has a no-break space before ; : ! ? and inside « »", () => {
		const wrong = Object.entries(french).flatMap(([room, texts]) =>
			Object.entries(texts)
				.filter(([, text]) => / [;:!?»]|« /.test(text))
				.map(([key]) => `${room}.${key}`),
		);
		expect(wrong).toEqual([]);
	});
});
