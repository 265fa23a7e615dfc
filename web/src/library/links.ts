/** Reads and writes links for the library. */
import { encodeLink } from "../specimen/link";
import { quote } from "../specimen/notes";
import { writtenSpecimen } from "../specimen/written";
import { type PlantRequest, readRequest, type Specimen } from "./grow";
import { text } from "./messages.generated";
import { linkIn, readLink, SpecimenError } from "./read_request";

/** The contents of a link. */
export interface ParsedLink {
	/** Complete and in range for any link. */
	readonly specimen: Specimen;
	/** Unusable parts of the link, with the values used in their place, in plain sentences. */
	readonly notes: readonly string[];
}

/**
 * Reads a link without growing it. Any link gives a specimen: links stay valid, and unusable parts are reported in
 * notes.
 * @param link - a whole address, or its part from the `?` on
 * @throws SpecimenError where the text is no link at all: it has neither `?` nor `#` nor `://`
 */
export async function parseLink(link: string): Promise<ParsedLink> {
	const parts = linkIn(link);
	if (!parts) throw new SpecimenError("link", text.message("not_a_link", { link: quote(link) }));
	const { model, specimen, notes } = await readLink(parts.query, parts.fragment);
	return { specimen: writtenSpecimen(model, specimen), notes: notes.map((note) => note.text) };
}

/**
 * The link of a specimen, which opens it in the app, the element and the service.
 * @param request - a specimen, values by their keys, a preset's name, or a link, which is written anew
 * @param page - the address of an app to open it in; without one, the link begins with its `?`
 * @throws SpecimenError where a preset's name or a value cannot be used
 */
export async function formatLink(request: PlantRequest, page = ""): Promise<string> {
	const { model, specimen } = await readRequest(request);
	return `${page}${await encodeLink(model, specimen)}`;
}
