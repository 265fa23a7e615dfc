/** Plants that were open in this browser lately, and the rule for which of them are listed. */

/** An entry of the list: one for each time that a plant is opened in a page; its edits change the entry. */
export interface RecentPlant {
	/** Unique among all pages of this browser. */
	readonly id: string;
	/** The link from its `?` on, with the fragment. */
	readonly link: string;
	readonly title: string;
	/** Time when it was opened or last changed, milliseconds since 1970. */
	readonly at: number;
	/** Time of its last edit; absent if it has only been looked at. */
	readonly editedAt?: number;
	/** Of a plant with parts that no link can hold: whether they are stored, too. */
	readonly extra?: "stored" | "missing";
}

/** The most plants in the list. */
export const MAX_RECENT = 6;
/** Greatest length of a link: that of a query and a fragment which links are read to, and some more. */
const LONGEST_LINK = 600_000;
const LONGEST_TITLE = 200;
/** The last time that `Date` can represent, milliseconds since 1970. */
const LAST_DAY = 8.64e15;

/**
 * Checks a stored value, which another version of the page may have written. Drops unknown fields; returns undefined
 * where the value is no plant.
 */
export function readRecent(value: unknown): RecentPlant | undefined {
	if (typeof value !== "object" || value === null) return undefined;
	const { id, link, title, at, editedAt, extra } = value as Partial<Record<keyof RecentPlant, unknown>>;
	if (typeof id !== "string" || !/^[\w-]{1,64}$/.test(id)) return undefined;
	if (typeof link !== "string" || !link.startsWith("?") || link.length > LONGEST_LINK) return undefined;
	if (typeof title !== "string" || title === "" || title.length > LONGEST_TITLE || !isTime(at)) return undefined;
	return {
		id,
		link,
		title,
		at,
		...(isTime(editedAt) ? { editedAt } : {}),
		...(extra === "stored" || extra === "missing" ? { extra } : {}),
	};
}

/** Returns whether a value is a time that `Date` can represent. */
const isTime = (at: unknown): at is number => typeof at === "number" && at >= 0 && at <= LAST_DAY;

/**
 * Returns the plants of the list, newest first. Where there are too many, edited plants stay before those that were
 * only looked at, and of both the newest.
 */
export function listed(plants: Iterable<RecentPlant>): readonly RecentPlant[] {
	const newest = [...plants].sort((a, b) => b.at - a.at || (a.id < b.id ? -1 : 1));
	const isEdited = ({ editedAt }: RecentPlant) => editedAt !== undefined;
	const ranked = [...newest.filter(isEdited), ...newest.filter((plant) => !isEdited(plant))];
	const chosen = new Set(ranked.slice(0, MAX_RECENT));
	return newest.filter((plant) => chosen.has(plant));
}

/**
 * Returns the list after a plant has been opened or changed. The plant replaces its own entry, and those with its link
 * or the link with which it was opened: continuing a plant makes no second entry.
 * @param from the link with which it was opened
 * @returns the list, and the ids of entries that the plant has replaced
 */
export function recorded(
	stored: readonly RecentPlant[],
	plant: RecentPlant,
	from = plant.link,
): { readonly plants: readonly RecentPlant[]; readonly replaced: readonly string[] } {
	const isOther = ({ id, link }: RecentPlant) => id !== plant.id && link !== plant.link && link !== from;
	const same = stored.filter((each) => each.id !== plant.id && !isOther(each));
	const editedAt = Math.max(plant.editedAt ?? 0, ...same.map((each) => each.editedAt ?? 0));
	const hasExtra = stored.some((each) => !isOther(each) && each.extra === "stored");
	const next = {
		...plant,
		...(editedAt > 0 ? { editedAt } : {}),
		// Its contents are taken over, too.
		...(plant.extra === "missing" && hasExtra ? { extra: "stored" as const } : {}),
	};
	return { plants: listed([next, ...stored.filter(isOther)]), replaced: same.map(({ id }) => id) };
}
