/**
 * The link: a specimen as the part of an address from the `?` on (docs/links.md). The query holds readable parameters,
 * only those that differ from the preset; long texts go compressed into the fragment, which never leaves the browser.
 * Reading never throws: any input gives a complete specimen and notes.
 */

import { compressText, expandText } from "./compressed_text";
import { DEFAULT_SEED, fromPreset } from "./from_preset";
import { text } from "./messages.generated";
import type { ModelSchema, Packed } from "./model_schema";
import { Notes } from "./notes";
import { type Restored, restore } from "./restore";
import { SPECIMEN_VERSION, type Specimen } from "./specimen";
import { writtenIn } from "./table";

/** The most characters that are read of a query and of a fragment; the rest is ignored. */
export const LONGEST_QUERY = 16 * 1024;
export const LONGEST_FRAGMENT = 512 * 1024;

/** Encodes the whole specimen: `?v=2&…#g=…`. */
export async function encodeLink<S extends Specimen>(schema: ModelSchema<S>, specimen: S): Promise<string> {
	const texts = textsOf(schema, specimen);
	const packed = await Promise.all(texts.map(async ([key, long]) => `${key}=${await compressText(long)}`));
	return `${encodeQuery(schema, specimen)}${packed.length > 0 ? `#${packed.join("&")}` : ""}`;
}

/** Returns the query of a specimen's link, `?v=2&…`, without its long texts. */
export function encodeQuery<S extends Specimen>(schema: ModelSchema<S>, specimen: S): string {
	const preset = fromPreset(schema, specimen.preset);
	const parts = [`v=${SPECIMEN_VERSION}`];
	if (!schema.unnamed) parts.push(`model=${schema.name}`);
	if (specimen.preset !== schema.presets.standard) parts.push(`preset=${specimen.preset}`);
	if (specimen.seed !== DEFAULT_SEED) parts.push(`seed=${specimen.seed}`);
	for (const [key, entries] of schema.table.links) {
		const values = entries.map((entry) => shortest(writtenIn(specimen, entry))).join(",");
		const before = entries.map((entry) => shortest(writtenIn(preset, entry))).join(",");
		if (values !== before) parts.push(`${key}=${values}`);
	}
	for (const { query } of schema.details) {
		for (const [key, value] of query?.(specimen, preset) ?? []) parts.push(`${key}=${value}`);
	}
	return `?${parts.join("&")}`;
}

/** Returns whether the query alone is the whole link. */
export function isQueryWhole<S extends Specimen>(schema: ModelSchema<S>, specimen: S): boolean {
	return textsOf(schema, specimen).length === 0;
}

/**
 * Returns the long texts of a specimen's link, uncompressed, by their keys in its fragment. Texts that equal the
 * preset's are left out.
 */
export function textsOf<S extends Specimen>(schema: ModelSchema<S>, specimen: S): [key: string, text: string][] {
	return packedOf(schema).flatMap(({ link: fragmentKey, textOf }) => {
		const own = textOf(specimen);
		const same = own === undefined || own === textOf(fromPreset(schema, specimen.preset));
		return same ? [] : [[fragmentKey, own]];
	});
}

/**
 * Reads a link.
 * @param search the query, with or without its `?`
 * @param hash the fragment, with or without its `#`
 */
export async function decodeLink<S extends Specimen>(
	schema: ModelSchema<S>,
	search: string,
	hash = "",
): Promise<Restored<S>> {
	const notes = new Notes();
	const values = valuesOf(search, notes);
	for (const packed of packedOf(schema)) {
		const expanded = await textIn(hash, packed, notes);
		if (expanded !== undefined) values[packed.key] = expanded;
	}
	return restored(schema, values, notes);
}

/**
 * Reads a link whose long texts are not compressed.
 * @param texts the texts by their keys in the fragment, as `textsOf` returns them; those that are too long are ignored
 */
export function decodeUnpacked<S extends Specimen>(
	schema: ModelSchema<S>,
	search: string,
	texts: Readonly<Record<string, string>>,
): Restored<S> {
	const notes = new Notes();
	const values = valuesOf(search, notes);
	for (const { link, key, longest } of packedOf(schema)) {
		if (Object.hasOwn(texts, link) && texts[link].length <= longest) values[key] = texts[link];
	}
	return restored(schema, values, notes);
}

/** Reads the query alone: at once, and all there is to most links. */
export function decodeQuery<S extends Specimen>(schema: ModelSchema<S>, search: string): Restored<S> {
	const notes = new Notes();
	return restored(schema, valuesOf(search, notes), notes);
}

/** Returns query and fragment of a whole address, or of a part that begins with one of them. */
export function linkParts(address: string): { query: string; fragment: string } {
	const hash = address.indexOf("#");
	const end = hash < 0 ? address.length : hash;
	const query = address.lastIndexOf("?", end);
	return { query: query < 0 ? "" : address.slice(query, end), fragment: address.slice(end) };
}

/** Returns the name of the model in a query; undefined where it names none. */
export function modelInQuery(search: string): string | undefined {
	return new URLSearchParams(search.slice(0, LONGEST_QUERY)).getAll("model").at(-1);
}

/** Returns whether a fragment holds anything of a specimen, so that the link needs `decodeLink`. */
export function hasPacked<S extends Specimen>(schema: ModelSchema<S>, hash: string): boolean {
	return packedOf(schema).some(({ link }) => inFragment(hash, link).length > 0);
}

/** Restores a specimen from a link's values, with notes on the link and on values that no link holds. */
function restored<S extends Specimen>(
	schema: ModelSchema<S>,
	values: Record<string, string>,
	notes: Notes,
): Restored<S> {
	const { specimen, notes: more } = restore(schema, values);
	for (const { unlinked } of schema.details) unlinked?.missing(specimen, notes);
	return { specimen, notes: [...notes.all(), ...more] };
}

/**
 * Splits a query into values by key; the last of repeated keys counts, and too long a query is cut, both with a note.
 */
function valuesOf(search: string, notes: Notes): Record<string, string> {
	if (search.length > LONGEST_QUERY)
		notes.add("link", text.message("link_too_long"), text("first_characters_read", { most: LONGEST_QUERY }));
	const values = new Map<string, string>();
	for (const [key, value] of new URLSearchParams(search.slice(0, LONGEST_QUERY))) {
		if (values.has(key)) noteRepeated(key, notes);
		values.set(key, value);
	}
	return Object.fromEntries(values);
}

/** Notes a key that a link repeats. */
function noteRepeated(key: string, notes: Notes): void {
	notes.add(key, text.message("repeated"), text("last_used"));
}

/** Returns the model's fields whose text a link carries in its fragment. */
function packedOf<S extends Specimen>({ details }: ModelSchema<S>): Packed<S>[] {
	return details.flatMap(({ packed }) => packed ?? []);
}

/**
 * Returns all values of a key in the fragment.
 * @param hash the fragment, with or without its `#`
 */
function inFragment(hash: string, link: string): string[] {
	return new URLSearchParams(hash.replace(/^#/, "").slice(0, LONGEST_FRAGMENT)).getAll(link);
}

/** Expands the text in a link's fragment; notes if it is damaged, repeated or too long. */
async function textIn<S extends Specimen>(
	hash: string,
	{ link, key, longest, otherwise }: Packed<S>,
	notes: Notes,
): Promise<string | undefined> {
	const values = inFragment(hash, link);
	const packed = values.at(-1);
	if (packed === undefined) return undefined;
	if (hash.length > LONGEST_FRAGMENT) {
		notes.add(key, text.message("link_too_long"), otherwise);
		return undefined;
	}
	if (values.length > 1) noteRepeated(key, notes);
	const expanded = await expandText(packed, longest);
	if (expanded === undefined) notes.add(key, text.message("link_damaged"), otherwise);
	return expanded;
}

/** Returns the shortest text of a value: numbers with at most two decimals, the precision of a specimen. */
function shortest(value: number | string): string {
	return typeof value === "string" ? value : String(Math.round(value * 100) / 100);
}
