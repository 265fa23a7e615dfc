/** Searches all entries of the command palette. */
import { searchPresets } from "../preset_search";
import { sectionsOf } from "../preset_sections";
import presetSynonyms from "../search/synonyms.json";
import { TextIndex } from "../search/text_index";
import type { Studio } from "../studio";
import actionSynonyms from "./action_synonyms.json";
import { type EntryGroup, GROUPS, type PaletteEntry, plantEntry } from "./entries";

/** The most entries of a group that are listed. */
const MAX_LISTED: Readonly<Record<EntryGroup, number>> = { plants: 8, settings: 8, actions: 8, help: 5 };

/** Entries of one group that match a query, best first. */
export interface FoundGroup {
	readonly group: EntryGroup | "recent_plants" | "recent" | "suggested";
	readonly entries: readonly PaletteEntry[];
}

/** Actions that an empty query lists, if they can be run. */
const SUGGESTED = ["browse", "variation", "undo", "download", "share", "saved", "open", "help"].map(
	(key) => `action:${key}`,
);

/** Begins the keys of presets (entries.ts). */
const PLANT = "plant:";

/** Makes the index of all entries but plants. */
export const indexOf = (entries: readonly PaletteEntry[]): TextIndex<PaletteEntry> =>
	new TextIndex(entries, ({ texts }) => texts, { ...presetSynonyms, ...actionSynonyms });

/**
 * Returns the entries that match a query by group: the group with the best match first.
 * @param index all entries but plants
 */
export function findEntries(studio: Studio, index: TextIndex<PaletteEntry>, query: string): readonly FoundGroup[] {
	const sections = sectionsOf(studio.state.catalogue);
	const search = (forgives: boolean) => [
		...searchPresets(sections, query, forgives).map(({ entry, score }) => ({
			entry: plantEntry(studio, entry),
			score,
		})),
		...index.search(query, forgives),
	];
	const exact = search(false);
	const scored = exact.length > 0 ? exact : search(true);
	return GROUPS.map((group) => scored.filter(({ entry }) => entry.group === group))
		.filter((own) => own.length > 0)
		.sort(([a], [b]) => a.score - b.score)
		.map((own) => own.map(({ entry }) => entry))
		.map((entries) => ({ group: entries[0].group, entries: entries.slice(0, MAX_LISTED[entries[0].group]) }));
}

/**
 * Returns the entries for an empty query: the plants that were open lately, the entries that were run last, and useful
 * actions.
 * @param entries all entries but plants
 * @param recent keys of entries, newest first
 * @param recentPlants entries of plants, newest first; presets that were chosen in the palette are among them
 */
export function entriesToStart(
	studio: Studio,
	entries: readonly PaletteEntry[],
	recent: readonly string[],
	recentPlants: readonly PaletteEntry[] = [],
): readonly FoundGroup[] {
	const named = (key: string) => entries.find((entry) => entry.key === key) ?? plantOf(studio, key);
	const isListed = (key: string) => recentPlants.length === 0 || !key.startsWith(PLANT);
	const last = recent.filter(isListed).flatMap((key) => named(key) ?? []);
	const others = SUGGESTED.filter((key) => !recent.includes(key)).flatMap((key) => named(key) ?? []);
	const groups: readonly FoundGroup[] = [
		{ group: "recent_plants", entries: recentPlants },
		{ group: "recent", entries: last },
		{ group: "suggested", entries: others },
	];
	return groups.filter((group) => group.entries.length > 0);
}

/** Returns the plant with a key such as "plant:growth/oak"; undefined where there is none. */
function plantOf(studio: Studio, key: string): PaletteEntry | undefined {
	for (const { model, kind, presets } of sectionsOf(studio.state.catalogue)) {
		const preset = presets.find(({ name }) => key === `${PLANT}${model.name}/${name}`);
		if (preset) return plantEntry(studio, { model, kind, preset });
	}
	return undefined;
}
