/** Searches and sorts saved specimens. */
import { isIn, wordsOf } from "../preset_search";
import type { Saved } from "./saved";

/** Labels of the sort orders. */
export const ORDERS = {
	newest: "Newest first",
	oldest: "Oldest first",
	name: "By name",
} as const;
export type SavedOrder = keyof typeof ORDERS;

const collator = new Intl.Collator("en", { numeric: true });
const compare: Readonly<Record<SavedOrder, (a: Saved, b: Saved) => number>> = {
	newest: (a, b) => b.at - a.at,
	oldest: (a, b) => a.at - b.at,
	name: (a, b) => collator.compare(a.name, b.name),
};

/**
 * @param query words in any order; each must occur in the name or in `about`
 * @param about further searchable text of a specimen: its model, its preset
 */
export function findSaved(
	all: readonly Saved[],
	query: string,
	order: SavedOrder,
	about: (saved: Saved) => string,
): readonly Saved[] {
	const words = wordsOf(query);
	// Compare ids last: the order is then the same in every tab.
	return all
		.filter((saved) => isIn(words, `${saved.name} ${about(saved)}`))
		.sort((a, b) => compare[order](a, b) || (a.id < b.id ? -1 : 1));
}
