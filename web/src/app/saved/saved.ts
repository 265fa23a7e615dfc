/** Specimens saved under a name, and checks of such specimens from files and storage. */
import { LONGEST_FRAGMENT, LONGEST_QUERY, linkParts, modelInQuery } from "../../specimen/link";
import { text } from "../messages.generated";
import { jpegSize, LARGEST_PICTURE, LONGEST_SIDE } from "./jpeg_size";

export interface Saved {
	/** A UUID, unique across browsers. */
	readonly id: string;
	/** The user's name for it; not unique. */
	readonly name: string;
	/** The link from its `?` on, with the fragment, of any version of links. */
	readonly link: string;
	/** Time of saving, milliseconds since 1970. */
	readonly at: number;
	/** The version of the app that saved it. */
	readonly app: string;
	/** Fingerprint of the saved plant, 16 hexadecimal digits. */
	readonly fingerprint?: string;
	/** A small JPEG. */
	readonly picture?: Uint8Array<ArrayBuffer>;
}

/** Greatest length of a name, characters. */
export const LONGEST_NAME = 120;
/** The last time that `Date` can represent, milliseconds since 1970. */
const LAST_DAY = 8.64e15;

/** A checked value, or its problem, a sentence. */
type Read<T> = { readonly value: T } | { readonly problem: string };

/**
 * Returns a name as shown: one line, without characters that change the writing direction, truncated. May be empty.
 */
export function tidyName(name: string): string {
	const line = name
		.slice(0, 16 * LONGEST_NAME)
		.replace(/[\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, "")
		.replace(/[\s\p{Cc}]+/gu, " ")
		.trim();
	return Array.from(line).slice(0, LONGEST_NAME).join("").trim();
}

/** Returns query and fragment of a link of any address; the address itself is dropped and never opened. */
export function readLink(link: unknown): Read<string> {
	if (typeof link !== "string") return { problem: text("library_link_not_text") };
	const { query, fragment } = linkParts(link);
	if (query === "") return { problem: text("library_link_no_query") };
	if (query.length > LONGEST_QUERY || fragment.length > LONGEST_FRAGMENT)
		return { problem: text("library_link_too_long") };
	return { value: `${query}${fragment}` };
}

/** Checks the size of a picture, so that decoding it is safe. */
export function readPicture(picture: Uint8Array<ArrayBuffer>): Read<Uint8Array<ArrayBuffer>> {
	if (picture.length > LARGEST_PICTURE) return { problem: pictureTooLarge() };
	const size = jpegSize(picture);
	if (!size) return { problem: text("library_picture_not_jpeg") };
	const { width, height } = size;
	if (Math.max(width, height) > LONGEST_SIDE)
		return { problem: text("library_picture_wide", { pixels: LONGEST_SIDE }) };
	return { value: picture };
}

/** Returns the problem of a picture with too many bytes. */
export const pictureTooLarge = (): string => text("library_picture_large", { kilobytes: LARGEST_PICTURE / 1024 });

/** Returns whether a value is a time that `Date` can represent. */
export const isTime = (at: unknown): at is number => typeof at === "number" && Math.abs(at) <= LAST_DAY;
/** Returns whether a value is a fingerprint: 16 hexadecimal digits. */
export const isFingerprint = (text: unknown): text is string => typeof text === "string" && /^[0-9a-f]{16}$/.test(text);

/** Returns whether a stored value is a saved specimen: another version of the page may have written it. */
export function isSaved(value: unknown): value is Saved {
	if (typeof value !== "object" || value === null) return false;
	const { id, name, link, at, app, fingerprint, picture } = value as Partial<Record<keyof Saved, unknown>>;
	return (
		[id, name, link, app].every((text) => typeof text === "string") &&
		isTime(at) &&
		(fingerprint === undefined || isFingerprint(fingerprint)) &&
		(picture === undefined || picture instanceof Uint8Array)
	);
}

/** Returns a key for the import, the same for specimens of the same name and link. */
export const sameness = ({ name, link }: Pick<Saved, "name" | "link">): string => JSON.stringify([name, link]);

/** Returns the number of specimens and the first one’s name, for messages that name a single one. */
export const countAndName = (several: readonly Saved[]): { count: number; name: string } => ({
	count: several.length,
	name: several[0]?.name ?? "",
});

/** Returns the name, with a number appended if it is taken: "Merlot", "Merlot 2". */
export function uniqueName(name: string, taken: Iterable<string>): string {
	const names = new Set(taken);
	for (let count = 2, unique = name; ; count++) {
		if (!names.has(unique)) return unique;
		unique = `${name} ${count}`;
	}
}

/** Returns the name of the specimen's model; undefined for the default. */
export const modelOf = ({ link }: Saved): string | undefined => modelInQuery(linkParts(link).query);
/** Returns the name of the specimen's preset; undefined for the model's default. */
export const presetOf = ({ link }: Saved): string | undefined =>
	new URLSearchParams(linkParts(link).query).get("preset") ?? undefined;
