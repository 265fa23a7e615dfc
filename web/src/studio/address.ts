/** The address bar: always holds the specimen that is at rest. */
import { decodeLink, decodeQuery, encodeLink, encodeQuery, hasGrammar } from "../specimen/link";
import type { Restored } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";

/** What the address says, at once; a grammar in the fragment has to be unpacked and follows by `readWhole`. */
export function readAddress({ search, hash }: Pick<Location, "search" | "hash">): Restored & { whole: boolean } {
	return { ...decodeQuery(search), whole: !hasGrammar(hash) };
}

/** What the address says, its grammar included. */
export function readWholeAddress({ search, hash }: Pick<Location, "search" | "hash">): Promise<Restored> {
	return decodeLink(search, hash);
}

let newest: Specimen | undefined;

/** Writes the specimen into the address bar in place of the one before. */
export async function writeAddress(specimen: Specimen): Promise<void> {
	newest = specimen;
	const link = specimen.grammar === undefined ? encodeQuery(specimen) : await encodeLink(specimen);
	// Packing a grammar takes its time: a newer specimen may have come to rest meanwhile.
	if (newest !== specimen || `${location.search}${location.hash}` === link) return;
	try {
		history.replaceState(null, "", `${location.pathname}${link}`);
	} catch {
		// Browsers forbid more than some hundred writes in a few seconds; the next one will hold.
	}
}

/** The whole link, for copying and for files. */
export async function linkOf(specimen: Specimen): Promise<string> {
	return `${location.origin}${location.pathname}${await encodeLink(specimen)}`;
}
