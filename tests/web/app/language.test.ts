import { readFileSync } from "node:fs";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { startLanguage } from "../../../web/src/app/language";
import messages from "../../../web/src/app/messages.json";
import { FIRST_VISIT, loadUi, pageOf, saveUi } from "../../../web/src/app/ui_state";
import { currentLanguage, preferredLanguage, useLanguage } from "../../../web/src/locale/locale";

/** The attributes of the page's elements by selector. */
let labels: Map<string, string>;
let root: { lang: string; dir: string };

beforeEach(() => {
	labels = new Map();
	root = { lang: "en", dir: "" };
	vi.stubGlobal("navigator", { languages: ["de-DE", "fr-CA", "en-GB"] });
	vi.stubGlobal("document", {
		documentElement: root,
		querySelector: (selector: string) => ({
			setAttribute: (name: string, value: string) => labels.set(`${selector} ${name}`, value),
		}),
	});
});

afterEach(async () => {
	vi.unstubAllGlobals();
	await useLanguage(preferredLanguage([]));
});

it("is the first of the browser's languages that has a catalogue", async () => {
	await startLanguage("");
	expect(currentLanguage().key).toBe("fr");
	expect(root).toEqual({ lang: "fr", dir: "ltr" });
});

it("is the chosen one, whatever the browser's languages are", async () => {
	await startLanguage("en");
	expect(root.lang).toBe("en");
	expect(labels).toEqual(new Map());
});

it("replaces the names in index.html unless it is English", async () => {
	await startLanguage("ar-XB");
	expect(root).toEqual({ lang: "ar-XB", dir: "rtl" });
	expect(labels.get("panicle-history aria-label")).toMatch(/^\[Hístóry ~+\]$/);
});

it("has in index.html the English texts of the catalogue", () => {
	const page = readFileSync(new URL("../../../web/index.html", import.meta.url), "utf8");
	const texts = Object.entries(messages).flatMap(([key, text]) => (key.startsWith("page_") ? [text] : []));
	expect(texts.filter((text) => !page.includes(`>${text}<`) && !page.includes(`"${text}"`))).toEqual([]);
});

it("is stored once it is chosen, and shared with other tabs", () => {
	let stored: string | null = null;
	const storage = {
		getItem: () => stored,
		setItem: (_key: string, text: string) => {
			stored = text;
		},
	};
	saveUi(storage, { ...FIRST_VISIT, language: "fr" }, FIRST_VISIT);
	expect(pageOf(loadUi(storage)).language).toBe("fr");
	// Another change of a tab that does not know the choice leaves it.
	saveUi(storage, { ...FIRST_VISIT, theme: "dark" }, FIRST_VISIT);
	expect(loadUi(storage).language).toBe("fr");
	// A language without a catalogue is the browser's.
	stored = '{"language":"xx"}';
	expect(loadUi(storage).language).toBe("");
});
