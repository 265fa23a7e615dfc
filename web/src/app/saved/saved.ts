/** Specimens saved under a name, and checks of such specimens from files and storage. */
import { LONGEST_FRAGMENT, LONGEST_QUERY, linkParts, modelInQuery } from "../../specimen/link";
import { jpegSize } from "./jpeg_size";

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
/** Greatest size of a picture, bytes; ten times that of a usual one. */
export const LARGEST_PICTURE = 96 * 1024;
/** Greatest width and height of a picture, pixels: a small file may decode to an image that fills the memory. */
const LONGEST_SIDE = 1024;
/** The last time that `Date` can represent, milliseconds since 1970. */
const LAST_DAY = 8.64e15;

/** A checked value, or its problem as the end of a sentence: "has no name". */
type Read<T> = { readonly value: T } | { readonly problem: string };

/** The name as shown: one line, without characters that change the writing direction, truncated. May be empty. */
export function tidyName(name: string): string {
	const line = name
		.slice(0, 16 * LONGEST_NAME)
		.replace(/[\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, "")
		.replace(/[\s\p{Cc}]+/gu, " ")
		.trim();
	return Array.from(line).slice(0, LONGEST_NAME).join("").trim();
}

/** Query and fragment of a link of any address; the address itself is dropped and never opened. */
export function readLink(link: unknown): Read<string> {
	if (typeof link !== "string") return { problem: "its link is not text" };
	const { query, fragment } = linkParts(link);
	if (query === "") return { problem: "its link has no “?”" };
	if (query.length > LONGEST_QUERY || fragment.length > LONGEST_FRAGMENT) return { problem: "its link is too long" };
	return { value: `${query}${fragment}` };
}

/** Checks the size of a picture, so that decoding it is safe. */
export function readPicture(picture: Uint8Array<ArrayBuffer>): Read<Uint8Array<ArrayBuffer>> {
	if (picture.length > LARGEST_PICTURE) return { problem: `its picture is larger than ${LARGEST_PICTURE / 1024} kB` };
	const size = jpegSize(picture);
	if (!size) return { problem: "its picture is no JPEG" };
	const { width, height } = size;
	if (Math.max(width, height) > LONGEST_SIDE) return { problem: `its picture is larger than ${LONGEST_SIDE} pixels` };
	return { value: picture };
}

export const isTime = (at: unknown): at is number => typeof at === "number" && Math.abs(at) <= LAST_DAY;
export const isFingerprint = (text: unknown): text is string => typeof text === "string" && /^[0-9a-f]{16}$/.test(text);

/** Whether a stored value is a saved specimen: another version of the page may have written it. */
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

/** Key of a specimen for the import: the same for specimens of the same name and link. */
export const sameness = ({ name, link }: Pick<Saved, "name" | "link">): string => JSON.stringify([name, link]);

/** The name, with a number appended if it is taken: "Merlot", "Merlot 2". */
export function uniqueName(name: string, taken: Iterable<string>): string {
	const names = new Set(taken);
	for (let count = 2, unique = name; ; count++) {
		if (!names.has(unique)) return unique;
		unique = `${name} ${count}`;
	}
}

/** The name of the specimen's model; undefined for the default. */
export const modelOf = ({ link }: Saved): string | undefined => modelInQuery(linkParts(link).query);
/** The name of the specimen's preset; undefined for the model's default. */
export const presetOf = ({ link }: Saved): string | undefined =>
	new URLSearchParams(linkParts(link).query).get("preset") ?? undefined;
