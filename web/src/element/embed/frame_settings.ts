/** Reads the settings in a frame's address. */

export interface FrameSettings {
	/** Query and fragment of a link. */
	readonly link: string;
	/** Attributes of the element. */
	readonly attributes: readonly (readonly [name: string, value: string])[];
	/** Origins that may send requests to the frame; undefined: all. */
	readonly allowed: readonly string[] | undefined;
}

/** Keys of the frame's query that become attributes of the element; no parameter has such a name. */
export const FRAME_KEYS = [
	"autorotate",
	"wind",
	"outdoors",
	"controls",
	"handles",
	"capture",
	"theme",
	"alt",
	"loading",
] as const;

/**
 * Splits an address: keys in FRAME_KEYS are attributes, `allow` lists origins that may send messages (undefined: all),
 * and the rest is the specimen's link. The last of repeated keys counts.
 */
export function frameSettings({ search, hash }: { search: string; hash: string }): FrameSettings {
	const query = new URLSearchParams(search);
	const attributes = FRAME_KEYS.flatMap((key) => {
		const value = query.getAll(key).at(-1);
		query.delete(key);
		return value === undefined ? [] : [[key, value] as const];
	});
	const allowed = query.has("allow") ? query.getAll("allow").flatMap((origins) => origins.split(",")) : undefined;
	query.delete("allow");
	return { link: `?${query}${hash}`, attributes, allowed: allowed?.flatMap(originOf) };
}

/** Returns the origin of an address, as in MessageEvent, in a list; an empty list for invalid addresses. */
function originOf(address: string): string[] {
	return URL.canParse(address) ? [new URL(address).origin] : [];
}
