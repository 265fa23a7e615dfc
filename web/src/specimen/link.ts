/**
 * The link: a specimen as the part of an address from the `?` on (docs/links.md). The query holds readable parameters,
 * only those that differ from the preset; long texts go compressed into the fragment, which never leaves the browser.
 * Reading never throws: any input gives a complete specimen and notes.
 */

import { compressText, expandText } from "./compressed_text";
import { DEFAULT_SEED, fromPreset } from "./from_preset";
import type { ModelSchema, Packed } from "./model_schema";
import { Notes } from "./notes";
import { type Restored, restore } from "./restore";
import { SPECIMEN_VERSION, type Specimen } from "./specimen";
import { writtenIn } from "./table";

/** The note on a key that a link repeats. */
const REPEATED = ["given more than once", "the last is read"] as const;
/** The most characters that are read of a query and of a fragment; the rest is ignored. */
export const LONGEST_QUERY = 16 * 1024;
export const LONGEST_FRAGMENT = 512 * 1024;

/** Encodes the whole specimen: `?v=2&…#g=…`. */
export async function encodeLink<S extends Specimen>(species: ModelSchema<S>, specimen: S): Promise<string> {
	const texts = textsOf(species, specimen);
	const packed = await Promise.all(texts.map(async ([key, text]) => `${key}=${await compressText(text)}`));
	return `${encodeQuery(species, specimen)}${packed.length > 0 ? `#${packed.join("&")}` : ""}`;
}

/** `?v=2&…`: the specimen without its long texts. */
export function encodeQuery<S extends Specimen>(species: ModelSchema<S>, specimen: S): string {
	const preset = fromPreset(species, specimen.preset);
	const parts = [`v=${SPECIMEN_VERSION}`];
	if (!species.unnamed) parts.push(`model=${species.name}`);
	if (specimen.preset !== species.presets.standard) parts.push(`preset=${specimen.preset}`);
	if (specimen.seed !== DEFAULT_SEED) parts.push(`seed=${specimen.seed}`);
	for (const [key, entries] of species.table.links) {
		const values = entries.map((entry) => shortest(writtenIn(specimen, entry))).join(",");
		const before = entries.map((entry) => shortest(writtenIn(preset, entry))).join(",");
		if (values !== before) parts.push(`${key}=${values}`);
	}
	for (const { query } of species.details) {
		for (const [key, value] of query?.(specimen, preset) ?? []) parts.push(`${key}=${value}`);
	}
	return `?${parts.join("&")}`;
}

/** Whether the query alone is the whole link. */
export function isQueryWhole<S extends Specimen>(species: ModelSchema<S>, specimen: S): boolean {
	return textsOf(species, specimen).length === 0;
}

/** The long texts of a specimen's link, uncompressed, by their keys in its fragment. Texts that equal the preset's are left out. */
export function textsOf<S extends Specimen>(species: ModelSchema<S>, specimen: S): [key: string, text: string][] {
	return packedOf(species).flatMap(({ link: fragmentKey, textOf }) => {
		const text = textOf(specimen);
		const same = text === undefined || text === textOf(fromPreset(species, specimen.preset));
		return same ? [] : [[fragmentKey, text]];
	});
}

/**
 * Reads a link.
 * @param search the query, with or without its `?`
 * @param hash the fragment, with or without its `#`
 */
export async function decodeLink<S extends Specimen>(
	species: ModelSchema<S>,
	search: string,
	hash = "",
): Promise<Restored<S>> {
	const notes = new Notes();
	const values = valuesOf(search, notes);
	for (const packed of packedOf(species)) {
		const text = await textIn(hash, packed, notes);
		if (text !== undefined) values[packed.key] = text;
	}
	return restored(species, values, notes);
}

/** Reads the query alone: at once, and all there is to most links. */
export function decodeQuery<S extends Specimen>(species: ModelSchema<S>, search: string): Restored<S> {
	const notes = new Notes();
	return restored(species, valuesOf(search, notes), notes);
}

/** Query and fragment of a whole address, or of a part that begins with one of them. */
export function linkParts(address: string): { query: string; fragment: string } {
	const hash = address.indexOf("#");
	const end = hash < 0 ? address.length : hash;
	const query = address.lastIndexOf("?", end);
	return { query: query < 0 ? "" : address.slice(query, end), fragment: address.slice(end) };
}

/** The name of the model that a query says it is of; undefined where it says none. */
export function modelInQuery(search: string): string | undefined {
	return new URLSearchParams(search.slice(0, LONGEST_QUERY)).getAll("model").at(-1);
}

/** Whether a fragment holds anything of a specimen, so that the link needs `decodeLink`. */
export function hasPacked<S extends Specimen>(species: ModelSchema<S>, hash: string): boolean {
	return packedOf(species).some(({ link }) => inFragment(hash, link).length > 0);
}

function restored<S extends Specimen>(
	species: ModelSchema<S>,
	values: Record<string, string>,
	notes: Notes,
): Restored<S> {
	const { specimen, notes: more } = restore(species, values);
	for (const { unlinked } of species.details) unlinked?.missing(specimen, notes);
	return { specimen, notes: [...notes.all(), ...more] };
}

function valuesOf(search: string, notes: Notes): Record<string, string> {
	if (search.length > LONGEST_QUERY) notes.add("link", "too long", `its first ${LONGEST_QUERY} characters are read`);
	const values = new Map<string, string>();
	for (const [key, value] of new URLSearchParams(search.slice(0, LONGEST_QUERY))) {
		if (values.has(key)) notes.add(key, ...REPEATED);
		values.set(key, value);
	}
	return Object.fromEntries(values);
}

function packedOf<S extends Specimen>({ details }: ModelSchema<S>): Packed<S>[] {
	return details.flatMap(({ packed }) => packed ?? []);
}

/** All values of a key in the fragment. */
function inFragment(hash: string, link: string): string[] {
	return new URLSearchParams(hash.replace(/^#/, "").slice(0, LONGEST_FRAGMENT)).getAll(link);
}

async function textIn<S extends Specimen>(
	hash: string,
	{ link, key, longest, otherwise }: Packed<S>,
	notes: Notes,
): Promise<string | undefined> {
	const values = inFragment(hash, link);
	const packed = values.at(-1);
	if (packed === undefined) return undefined;
	if (hash.length > LONGEST_FRAGMENT) {
		notes.add(key, "the link is too long", otherwise);
		return undefined;
	}
	if (values.length > 1) notes.add(key, ...REPEATED);
	const text = await expandText(packed, longest);
	if (text === undefined) notes.add(key, "the link is damaged here", otherwise);
	return text;
}

/** The shortest text of a number: at most two decimals, the precision of a specimen. */
function shortest(value: number | string): string {
	return typeof value === "string" ? value : String(Math.round(value * 100) / 100);
}
