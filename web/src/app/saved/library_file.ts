/** Writes the saved specimens to one file and reads them (docs/saved.md). Files are not trusted: every problem is reported with its place. */

import { LIBRARY_FORMAT } from "../../formats/restore";
import { DEFAULT_MODEL } from "../../models/index";
import { formatCount } from "../../ui/thousands";
import { VERSION } from "../version";
import { isFingerprint, isTime, LARGEST_PICTURE, modelOf, readLink, readPicture, type Saved, tidyName } from "./saved";

const FORMAT_VERSION = 1;

/** Greatest number of specimens in a file. */
const MOST = 10_000;
const PICTURE = "data:image/jpeg;base64,";

/** The whole file cannot be used; the message is a sentence. */
export class LibraryError extends Error {
	override name = "LibraryError";
}

/** The content of a file. */
export interface Brought {
	readonly saved: readonly Saved[];
	/** Problems found, a sentence for each place. */
	readonly problems: readonly string[];
}

/** Writes a library's file. @param at time of writing, milliseconds since 1970 */
export function writeLibrary(saved: readonly Saved[], at: number): Blob {
	const document = {
		format: LIBRARY_FORMAT,
		version: FORMAT_VERSION,
		app: VERSION,
		exported: new Date(at).toISOString(),
		specimens: saved.map((each) => ({
			name: each.name,
			link: each.link,
			model: modelOf(each) ?? DEFAULT_MODEL,
			saved: new Date(each.at).toISOString(),
			app: each.app,
			fingerprint: each.fingerprint,
			picture: each.picture && PICTURE + base64Of(each.picture),
		})),
	};
	return new Blob([JSON.stringify(document, null, "\t")], { type: "application/json" });
}

/**
 * Reads a library's file.
 * @param document parsed JSON whose `format` is LIBRARY_FORMAT; the rest is not trusted
 * @throws LibraryError if nothing in it can be read
 */
export function readLibrary(document: unknown): Brought {
	const version = field(document, "version");
	if (version !== FORMAT_VERSION) {
		const newer = typeof version === "number" && version > FORMAT_VERSION;
		throw new LibraryError(
			newer
				? `It was written by a newer version of Panicle (version ${version} of the file); load the page again.`
				: "Its “version” is not 1.",
		);
	}
	const list = field(document, "specimens");
	if (!Array.isArray(list)) throw new LibraryError("Its “specimens” are no list.");
	if (list.length > MOST) throw new LibraryError(`It holds ${list.length} specimens; at most ${MOST} can be read.`);
	const read = list.map((record, index) => readOne(record, index + 1));
	return { saved: read.flatMap(({ saved }) => saved ?? []), problems: read.flatMap(({ problems }) => problems) };
}

/** Greatest number of problems shown; a last line counts the rest, so that a hostile file cannot fill the page. */
const MOST_LINES = 8;

/** The message about an import. @param came number of specimens that were new */
export function broughtInWords(
	{ saved, problems }: Brought,
	came: number,
): { words: string; lines: readonly string[] } {
	const there = saved.length - came;
	const words =
		came === 0 && there > 0
			? `Nothing new: ${there === 1 ? "it was" : `all ${formatCount(there)} were`} there already.`
			: `${formatCount(came)} imported${there > 0 ? `; ${formatCount(there)} there already` : ""}.`;
	const more = problems.length - MOST_LINES;
	return {
		words,
		lines: [...problems.slice(0, MOST_LINES), ...(more > 0 ? [`So it is with ${formatCount(more)} more.`] : [])],
	};
}

function readOne(record: unknown, count: number): { saved?: Saved; problems: string[] } {
	const written = field(record, "name");
	const name = typeof written === "string" ? tidyName(written) : "";
	const place = name === "" ? `No. ${count}` : `No. ${count}, “${name}”`;
	const leftOut = (problem: string) => ({ problems: [`${place}: ${problem}; it is left out.`] });
	if (typeof record !== "object" || record === null) return leftOut("it is no specimen");
	if (name === "") return leftOut("it has no name");
	const link = readLink(field(record, "link"));
	if ("problem" in link) return leftOut(link.problem);
	const picture = pictureIn(field(record, "picture"));
	const saved = field(record, "saved");
	const at = typeof saved === "string" ? Date.parse(saved) : 0;
	const app = field(record, "app");
	const fingerprint = field(record, "fingerprint");
	return {
		saved: {
			id: crypto.randomUUID(),
			name,
			link: link.value,
			at: isTime(at) ? at : 0,
			app: typeof app === "string" ? tidyName(app) : "",
			...(isFingerprint(fingerprint) ? { fingerprint } : {}),
			...("value" in picture && picture.value ? { picture: picture.value } : {}),
		},
		problems: "problem" in picture ? [`${place}: ${picture.problem}; it comes without.`] : [],
	};
}

function pictureIn(text: unknown): ReturnType<typeof readPicture> | { value: undefined } {
	if (text === undefined || text === null) return { value: undefined };
	if (typeof text !== "string" || !text.startsWith(PICTURE)) return { problem: "its picture is no JPEG" };
	// Check the size before decoding: base64 has four letters for three bytes.
	if (text.length > PICTURE.length + LARGEST_PICTURE * (4 / 3) + 4)
		return { problem: `its picture is larger than ${LARGEST_PICTURE / 1024} kB` };
	try {
		return readPicture(Uint8Array.from(atob(text.slice(PICTURE.length)), (letter) => letter.charCodeAt(0)));
	} catch {
		return { problem: "its picture is damaged" };
	}
}

function base64Of(bytes: Uint8Array): string {
	let binary = "";
	for (const byte of bytes) binary += String.fromCharCode(byte);
	return btoa(binary);
}

function field(value: unknown, key: string): unknown {
	return typeof value === "object" && value !== null && Object.hasOwn(value, key)
		? (value as Record<string, unknown>)[key]
		: undefined;
}
