/** Checks whether an address names a plant. Separate from address.ts, of which the home page needs nothing. */

/** Keys that other sites add to addresses, and which do not describe a plant. */
const FOREIGN = /^(utm_\w+|fbclid|gclid|ref|source)$/;

/** Returns whether the query or the fragment of an address names a plant. */
export function namesPlant({ search, hash }: Pick<Location, "search" | "hash">): boolean {
	const keys = [...new URLSearchParams(search).keys()];
	return hash.length > 1 || keys.some((key) => !FOREIGN.test(key));
}
