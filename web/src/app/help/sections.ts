/** The sections of the help, in the order of its contents. */
import { text } from "./messages.generated";

export const SECTIONS = ["start", "shape", "view", "growth", "files", "find", "keyboard", "language", "about"] as const;

export type SectionKey = (typeof SECTIONS)[number];

/** Returns the title of a section: "First steps". */
export const sectionTitle = (key: SectionKey): string => text(`title_${key}`);

/** A page of the documentation that a section links to. */
type DocsPage =
	| "quick_start"
	| "troubleshooting"
	| "glossary"
	| "parameters"
	| "measures"
	| "targets"
	| "gestures"
	| "rendering"
	| "studio"
	| "language"
	| "export"
	| "links"
	| "saved"
	| "element"
	| "gallery"
	| "offline"
	| "all";

/** The pages of the documentation that each section links to. */
const PAGES: Readonly<Record<SectionKey, readonly DocsPage[]>> = {
	start: ["quick_start", "troubleshooting", "glossary"],
	shape: ["parameters", "measures", "targets"],
	view: ["gestures", "rendering"],
	growth: ["studio", "language"],
	files: ["export", "links", "saved", "element"],
	find: ["gallery"],
	keyboard: ["studio"],
	language: [],
	about: ["all", "offline"],
};

/**
 * Returns the links of a section to the documentation.
 * @param model whose parameters and measures they lead to
 */
export const docsLinks = (section: SectionKey, model: string): readonly { address: string; title: string }[] =>
	PAGES[section].map((page) => ({ address: addressOf(page, model), title: text(`page_${page}`) }));

/** Returns the address of a page of the documentation, relative to the page of the app. */
function addressOf(page: DocsPage, model: string): string {
	if (page === "all") return "docs/";
	if (page === "parameters" || page === "measures") return `docs/models/${model}/${page}.html`;
	return `docs/${page.replaceAll("_", "-")}.html`;
}
