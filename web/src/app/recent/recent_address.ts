/** The id of a recent plant in an address, of a plant with parts that no link can hold: `#recent=ID`. */

/** Returns the id of a recent plant in a fragment; undefined where it has none. */
export function recentInAddress({ hash }: Pick<Location, "hash">): string | undefined {
	if (!hash.includes("recent=")) return undefined;
	return new URLSearchParams(hash.slice(1)).get("recent") ?? undefined;
}
