import { afterEach, describe, expect, it } from "vitest";
import { formatList, plural, show } from "../../../web/src/locale/format";
import { languageOf, preferredLanguage, useLanguage } from "../../../web/src/locale/locale";
import { textsOf } from "../../../web/src/locale/texts";

const french = { key: "fr", tag: "fr-FR", name: "Français", direction: "ltr" } as const;
const english = preferredLanguage([]);

const text = textsOf("room", {
	copy: "Copy",
	berries: ({ count }: { count: string | number }) =>
		plural(count, { "=0": "no berries", one: `${show(count)} berry`, other: `${show(count)} berries` }),
	press: ({ key, again }: { key: string; again: string }) => `Press ${key}, then ${again}.`,
});

afterEach(() => useLanguage(english));

describe("texts", () => {
	it("returns the English text, with its arguments, without a catalogue", () => {
		expect(text("copy")).toBe("Copy");
		expect(text("berries", { count: 0 })).toBe("no berries");
		expect(text("berries", { count: 1 })).toBe("1 berry");
		expect(text("berries", { count: 12_000 })).toBe("12,000 berries");
	});

	it("returns the translation of the language in use, and English where it has none", async () => {
		const entries: Record<string, string> = { "room.copy": "Copier" };
		await useLanguage({ ...french, load: async () => (code) => entries[code] });
		expect(text("copy")).toBe("Copier");
		expect(text("berries", { count: 2 })).toBe("2 berries");
		expect(show(12_000)).toBe("12\u202f000");
		expect(formatList(["a", "b", "c"])).toBe("a, b et c");
	});

	it("stays English where a catalogue cannot be fetched", async () => {
		await useLanguage({ ...french, load: () => Promise.reject(new Error("offline")) });
		expect(text("copy")).toBe("Copy");
		expect(show(12_000)).toBe("12,000");
	});

	it("returns drawn arguments at their places", () => {
		const [key, again] = [{ drawn: "?" }, { drawn: "!" }];
		expect(text.pieces("press", { key, again })).toEqual(["Press ", key, ", then ", again, "."]);
	});

	it("returns a code and arguments with a message", () => {
		expect(text.message("berries", { count: 2 })).toEqual({
			code: "room.berries",
			args: { count: 2 },
			text: "2 berries",
		});
	});

	it("finds the language of a tag by its first part, and pseudo-languages by their whole tag only", () => {
		expect(languageOf("fr-CA")?.key).toBe("fr");
		expect(languageOf("en-XA")?.name).toBe("Pseudo (long)");
		expect(languageOf("de")).toBeUndefined();
		expect(preferredLanguage(["de-DE", "fr-BE", "en"]).key).toBe("fr");
		expect(preferredLanguage(["de-DE"]).key).toBe("en");
	});
});
