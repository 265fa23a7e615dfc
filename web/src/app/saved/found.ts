/** Searches and sorts saved specimens. */
import { localeTag } from "../../locale/locale";
import synonyms from "../search/synonyms.json";
import { TextIndex } from "../search/text_index";
import { plain } from "../search/words";
import type { Saved } from "./saved";

/** The sort orders. */
export const ORDERS = ["newest", "oldest", "name"] as const;
export type SavedOrder = (typeof ORDERS)[number];

const compare: Readonly<Record<SavedOrder, (a: Saved, b: Saved) => number>> = {
	newest: (a, b) => b.at - a.at,
	oldest: (a, b) => a.at - b.at,
	name: (a, b) => compareNames(a.name, b.name),
};

/** Compares names in the order of the language, numbers in them by their values. */
function compareNames(a: string, b: string): number {
	if (collator?.[0] !== localeTag()) collator = [localeTag(), new Intl.Collator(localeTag(), { numeric: true })];
	return collator[1].compare(a, b);
}

let collator: [tag: string, Intl.Collator] | undefined;

/**
 * Returns the saved specimens that match a search, in an order.
 * @param query words in any order; each must occur in the name or in `about`. Where no specimen has them all, plurals,
 *   synonyms and typos count, too
 * @param about further searchable text of a specimen: its model, its preset
 */
export function findSaved(
	all: readonly Saved[],
	query: string,
	order: SavedOrder,
	about: (saved: Saved) => string,
): readonly Saved[] {
	const words = plain(query).split(/\s+/).filter(Boolean);
	const exact = all.filter((saved) => containsAll(words, `${saved.name} ${about(saved)}`));
	const index = () => new TextIndex(all, (saved) => ({ title: saved.name, names: [about(saved)] }), synonyms);
	const found = exact.length > 0 ? exact : [...index().find(query)];
	// Compare ids last: the order is then the same in every tab.
	return found.sort((a, b) => compare[order](a, b) || (a.id < b.id ? -1 : 1));
}

/** Returns whether a text contains each of the words. */
function containsAll(words: readonly string[], text: string): boolean {
	const simplified = plain(text);
	return words.every((word) => simplified.includes(word));
}
