/** A specimen that a person has kept under a name, and what of one from outside can be used. */
import { LONGEST_FRAGMENT, LONGEST_QUERY, linkParts, modelInQuery } from "../../specimen/link";
import { jpegSize } from "./jpeg_size";

export interface Saved {
	/** Its own in whatever browser. */
	readonly id: string;
	/** What the person calls it; two may be called the same. */
	readonly name: string;
	/** From its `?` on, with the fragment: this is the specimen, of whatever version of links. */
	readonly link: string;
	/** Milliseconds since 1970. */
	readonly at: number;
	/** The version of the app that saved it. */
	readonly app: string;
	/** 16 hexadecimal digits of the plant that was seen. */
	readonly fingerprint?: string;
	/** A small JPEG. */
	readonly picture?: Uint8Array<ArrayBuffer>;
}

/** Characters. */
export const LONGEST_NAME = 120;
/** Bytes; those that are made here have a tenth of it. */
export const LARGEST_PICTURE = 96 * 1024;
/** Pixels: a few bytes may unpack to as many as fill the memory. */
const LONGEST_SIDE = 1024;
/** Later than any clock says; `Date` ends there. */
const LAST_DAY = 8.64e15;

/** A part of it as it came, or a sentence's end that says what is wrong: "has no name". */
type Read<T> = { readonly value: T } | { readonly problem: string };

/** The name as it is shown: one line, without what turns the direction of writing, cut where it is too long. Empty where nothing is left. */
export function tidyName(name: string): string {
	const line = name
		.slice(0, 16 * LONGEST_NAME)
		.replace(/[\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, "")
		.replace(/[\s\p{Cc}]+/gu, " ")
		.trim();
	return Array.from(line).slice(0, LONGEST_NAME).join("").trim();
}

/** A link of whatever address, without that address. It is never followed, only read. */
export function readLink(link: unknown): Read<string> {
	if (typeof link !== "string") return { problem: "its link is not text" };
	const { query, fragment } = linkParts(link);
	if (query === "") return { problem: "its link has no “?”" };
	if (query.length > LONGEST_QUERY || fragment.length > LONGEST_FRAGMENT) return { problem: "its link is too long" };
	return { value: `${query}${fragment}` };
}

/** A picture that can be shown without harm. */
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

/** Whether what the browser has kept is one: it may be of another version of this page. */
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

/** The same text for what is the same to a person, so that one of them is enough. */
export const sameness = ({ name, link }: Pick<Saved, "name" | "link">): string => JSON.stringify([name, link]);

/** The name, with a number after it where it is taken: "Merlot", "Merlot 2". */
export function uniqueName(name: string, taken: Iterable<string>): string {
	const names = new Set(taken);
	for (let count = 2, unique = name; ; count++) {
		if (!names.has(unique)) return unique;
		unique = `${name} ${count}`;
	}
}

/** The name of the model that it is of; undefined for the default. */
export const modelOf = ({ link }: Saved): string | undefined => modelInQuery(linkParts(link).query);
/** The name of the preset that it started from; undefined for the model's own. */
export const presetOf = ({ link }: Saved): string | undefined =>
	new URLSearchParams(linkParts(link).query).get("preset") ?? undefined;
