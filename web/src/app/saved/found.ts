/** What of a library is shown, and in which order. */
import { isIn, wordsOf } from "../preset_search";
import type { Saved } from "./saved";

/** Orders by their keys, as a list offers them. */
export const ORDERS = {
	newest: "Newest first",
	oldest: "Oldest first",
	name: "By name",
} as const;
export type Order = keyof typeof ORDERS;

const collator = new Intl.Collator("en", { numeric: true });
const compare: Readonly<Record<Order, (a: Saved, b: Saved) => number>> = {
	newest: (a, b) => b.at - a.at,
	oldest: (a, b) => a.at - b.at,
	name: (a, b) => collator.compare(a.name, b.name),
};

/**
 * @param query words in any order, each to be found in what one is called or of
 * @param about what else is said of one: its model, its preset
 */
export function findSaved(
	all: readonly Saved[],
	query: string,
	order: Order,
	about: (saved: Saved) => string,
): readonly Saved[] {
	const words = wordsOf(query);
	// Ids last, so that the order is the same in every tab.
	return all
		.filter((saved) => isIn(words, `${saved.name} ${about(saved)}`))
		.sort((a, b) => compare[order](a, b) || (a.id < b.id ? -1 : 1));
}
