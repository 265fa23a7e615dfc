/**
 * Writes the saved specimens to one file and reads them (docs/saved.md). Files are not trusted: every problem is
 * reported with its place.
 */

import { LIBRARY_FORMAT } from "../../formats/restore";
import { MessageError } from "../../locale/message_error";
import { DEFAULT_MODEL } from "../../models/index";
import { fieldOf } from "../../specimen/read_values";
import { text } from "../messages.generated";
import { VERSION } from "../version";
import { LARGEST_PICTURE } from "./jpeg_size";
import { isFingerprint, isTime, modelOf, pictureTooLarge, readLink, readPicture, type Saved, tidyName } from "./saved";

const FORMAT_VERSION = 1;

/** Greatest number of specimens in a file. */
const MAX_SPECIMENS = 10_000;
const PICTURE = "data:image/jpeg;base64,";

/** The whole file cannot be used; the message has the reason. */
export class LibraryError extends MessageError {
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
	const version = fieldOf(document, "version");
	if (version !== FORMAT_VERSION) {
		const newer = typeof version === "number" && version > FORMAT_VERSION;
		throw new LibraryError(
			newer ? text.message("library_newer", { version: `${version}` }) : text.message("library_version"),
		);
	}
	const list = fieldOf(document, "specimens");
	if (!Array.isArray(list)) throw new LibraryError(text.message("library_no_list"));
	if (list.length > MAX_SPECIMENS)
		throw new LibraryError(text.message("library_too_many", { count: list.length, most: MAX_SPECIMENS }));
	const read = list.map((record, index) => readOne(record, index + 1));
	return { saved: read.flatMap(({ saved }) => saved ?? []), problems: read.flatMap(({ problems }) => problems) };
}

/** Greatest number of problems shown; a last line counts the rest, so that a hostile file cannot fill the page. */
const MAX_LINES = 8;

/** Returns the message about an import. @param came number of specimens that were new */
export function broughtInWords({ saved, problems }: Brought, came: number): { text: string; lines: readonly string[] } {
	const known = saved.length - came;
	const summary =
		known === 0
			? text("saved_imported", { count: came })
			: came === 0
				? text("saved_imported_none", { known })
				: text("saved_imported_some", { count: came, known });
	const more = problems.length - MAX_LINES;
	return {
		text: summary,
		lines: [...problems.slice(0, MAX_LINES), ...(more > 0 ? [text("saved_import_more", { count: more })] : [])],
	};
}

/**
 * Reads one record. A record without a name or a readable link is skipped; a bad picture is left out.
 * @param count number of the record in the file, from 1, for messages
 */
function readOne(record: unknown, count: number): { saved?: Saved; problems: string[] } {
	const written = fieldOf(record, "name");
	const name = typeof written === "string" ? tidyName(written) : "";
	const plant =
		name === "" ? text("library_plant", { number: count }) : text("library_plant_named", { number: count, name });
	const skipped = (problem: string) => ({ problems: [text("library_skipped", { plant, problem })] });
	if (typeof record !== "object" || record === null) return skipped(text("library_not_plant"));
	if (name === "") return skipped(text("library_no_name"));
	const link = readLink(fieldOf(record, "link"));
	if ("problem" in link) return skipped(link.problem);
	const picture = pictureIn(fieldOf(record, "picture"));
	const saved = fieldOf(record, "saved");
	const at = typeof saved === "string" ? Date.parse(saved) : 0;
	const app = fieldOf(record, "app");
	const fingerprint = fieldOf(record, "fingerprint");
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
		problems: "problem" in picture ? [text("library_no_picture", { plant, problem: picture.problem })] : [],
	};
}

/** Decodes a picture's data URL (JPEG, base64); the value is undefined if there is none. */
function pictureIn(written: unknown): ReturnType<typeof readPicture> | { value: undefined } {
	if (written === undefined || written === null) return { value: undefined };
	if (typeof written !== "string" || !written.startsWith(PICTURE)) return { problem: text("library_picture_not_jpeg") };
	// Check the size before decoding: base64 has four letters for three bytes.
	if (written.length > PICTURE.length + LARGEST_PICTURE * (4 / 3) + 4) return { problem: pictureTooLarge() };
	try {
		return readPicture(Uint8Array.from(atob(written.slice(PICTURE.length)), (letter) => letter.charCodeAt(0)));
	} catch {
		return { problem: text("library_picture_damaged") };
	}
}

/** Encodes bytes in base 64. */
function base64Of(bytes: Uint8Array): string {
	let binary = "";
	for (const byte of bytes) binary += String.fromCharCode(byte);
	return btoa(binary);
}
