/** What a frame's address says besides its link. */

export interface FrameSettings {
	/** Query and fragment of a link. */
	readonly link: string;
	/** Of the element. */
	readonly attributes: readonly (readonly [name: string, value: string])[];
	/** Origins that may ask the frame; undefined: all. */
	readonly allowed: readonly string[] | undefined;
}

/** Keys of the frame's query that go to the element; no parameter is called so. */
export const FRAME_KEYS = ["autorotate", "wind", "controls", "handles", "theme", "alt", "loading"] as const;

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

/** An address's origin as messages have it; what is none allows nobody. */
function originOf(address: string): string[] {
	return URL.canParse(address) ? [new URL(address).origin] : [];
}
