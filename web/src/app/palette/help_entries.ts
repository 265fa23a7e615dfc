/** The help in the command palette: its sections, and the pages of the documentation, which are opened in new tabs. */
import type { Help } from "../help/help";
import { HELP } from "../parts/late_parts";
import { openPart } from "../parts/open_part";
import type { Studio } from "../studio";
import type { PaletteEntry } from "./entries";
import { text } from "./messages.generated";

/** A section of the documentation's navigation (wasm-core/tools/site/build.mjs writes them). */
interface DocsSection {
	readonly title: string;
	/** Addresses are below docs/. */
	readonly pages: readonly { readonly address: string; readonly title: string }[];
}

const FOLDER = "docs/";

let loading: Promise<readonly DocsSection[]> | undefined;

/** Returns the sections of the documentation, fetched once; a later call tries again after an error. */
function docsSections(): Promise<readonly DocsSection[]> {
	loading ??= fetch(`${FOLDER}pages.json`).then((response) => {
		if (!response.ok) throw new Error(`Status ${response.status}`);
		return response.json();
	});
	loading.catch(() => {
		loading = undefined;
	});
	return loading;
}

/** Returns the entries of the sections of the help. Rejects where its script cannot be fetched. */
export async function sectionEntries(studio: Studio): Promise<readonly PaletteEntry[]> {
	const { SECTIONS, sectionTitle } = await import("../help/sections");
	return SECTIONS.map((section) => {
		const title = text("help_section", { section: sectionTitle(section) });
		return {
			key: `help:${section}`,
			group: "help",
			title,
			about: "",
			icon: "help",
			texts: { title },
			run: () => openPart<Help>(studio, HELP, (help) => help.open(section)),
		};
	});
}

/**
 * Returns the entries of all pages, the parameters of the shown model first. Rejects where the list cannot be fetched.
 */
export async function helpEntries(studio: Studio): Promise<readonly PaletteEntry[]> {
	const own = `models/${studio.state.model.name}/parameters.html`;
	const sections = await docsSections();
	const all = sections.flatMap(({ title: section, pages }) =>
		pages.map(({ address, title }) => entryOf(address, address === own ? text("parameters_page") : title, section)),
	);
	const isOwn = ({ key }: PaletteEntry) => key === keyOf(own);
	return [...all.filter(isOwn), ...all.filter((entry) => !isOwn(entry))];
}

/** Returns the key of a page's entry. */
const keyOf = (address: string): string => `page:${address}`;

/**
 * Returns the entry of a page of the documentation.
 * @param section title of the page's section
 */
function entryOf(address: string, title: string, section: string): PaletteEntry {
	return {
		key: keyOf(address),
		group: "help",
		title,
		about: text("page_about", { section }),
		icon: "help",
		texts: { title, names: [address.replace(/\.html$/, "")], shelves: [section] },
		run: () => openPage(FOLDER + address),
	};
}

/** Opens a page of the documentation in a new tab. */
function openPage(address: string): void {
	const link = document.createElement("a");
	link.href = address;
	link.target = "_blank";
	link.rel = "noopener";
	link.click();
}
