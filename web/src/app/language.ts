/** The language of the page: the chosen one, else the first of the browser's that has a catalogue. */
import { currentLanguage, languageOf, preferredLanguage, useLanguage } from "../locale/locale";
import { text } from "./messages.generated";

/** Names of the parts in index.html, which has them in English. */
const LABELS = {
	"panicle-family": "page_plant",
	"panicle-history": "page_history",
	"panicle-share": "page_share",
	"panicle-variation": "page_variation",
	"panicle-bars": "page_bars",
	".gallery": "page_presets",
	".panel": "page_controls",
	"panicle-notices": "page_notices",
} as const;

/**
 * Loads the language and marks the page with it, before anything is drawn.
 * @param chosen the tag that the user has chosen; "" for none
 */
export async function startLanguage(chosen: string): Promise<void> {
	await useLanguage(languageOf(chosen) ?? preferredLanguage(navigator.languages));
	const { key, direction } = currentLanguage();
	document.documentElement.lang = key;
	document.documentElement.dir = direction;
	if (key !== "en") translatePage();
}

/** Translates the texts of index.html. */
function translatePage(): void {
	document.title = text("page_title");
	for (const [selector, key] of Object.entries(LABELS))
		document.querySelector(selector)?.setAttribute("aria-label", text(key));
	document.querySelector(".home-link")?.setAttribute("title", text("page_home"));
	const skip = document.querySelector(".skip");
	if (skip) skip.textContent = text("page_skip");
}
