/** Adds links to the frozen ones: add_links.mjs loads this module through Vite, which finds the models. */
import { isFrozen, linksToFreeze, meantBy, modelOf, readFrozenLinks, versionOf, writeFrozenLinks } from "./list";

/**
 * @param links where empty: all that have to be listed and are not
 * @returns the links that were added
 * @throws Error where a link belongs to a preview, or cannot be read as it is
 */
export async function addLinks(links: readonly string[]): Promise<string[]> {
	const listed = readFrozenLinks();
	const known = new Set(listed.map(({ link }) => link));
	const candidates = links.length > 0 ? links : await linksToFreeze();
	const added = [...new Set(candidates)].filter((link) => !known.has(link));
	const grown = [];
	for (const link of added) {
		if (!isFrozen(await modelOf(link), versionOf(link)))
			throw new Error(`${link}: only links that are no previews can be frozen.`);
		const { notes, fingerprint } = await meantBy(link);
		if (notes.length > 0) throw new Error(`${link}: ${notes.join(" ")}`);
		grown.push({ link, fingerprint });
	}
	if (grown.length > 0) writeFrozenLinks([...listed, ...grown]);
	return added;
}
