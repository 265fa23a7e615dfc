/**
 * The link: a specimen as the part of an address from the `?` on (docs/links.md). Parameters are readable in the
 * query, only what differs from the preset; grammar text goes compressed into the fragment, which never leaves the
 * browser. Reading never throws: whatever comes in gives a complete specimen and notes.
 */

import { DEFAULT_PRESET } from "../models/bunch/presets/index";
import { compressText, expandText } from "./compressed_text";
import { DEFAULT_SEED, specimenFromPreset } from "./from_preset";
import { GRAMMAR_BYTES } from "./limits";
import { Notes } from "./notes";
import { type Restored, restore } from "./restore";
import { SPECIMEN_VERSION, type Specimen } from "./specimen";
import { byLink, writtenIn } from "./table";
import { writeThinned } from "./thinned";

/** Characters that are read of a query and of a fragment; the rest is not looked at. */
const LONGEST_QUERY = 16 * 1024;
const LONGEST_FRAGMENT = 512 * 1024;

/** `?v=2&…#g=…`: the whole specimen. */
export async function encodeLink(specimen: Specimen): Promise<string> {
	const query = encodeQuery(specimen);
	return specimen.grammar === undefined ? query : `${query}#g=${await compressText(specimen.grammar)}`;
}

/** `?v=2&…`: the specimen without its grammar text. */
export function encodeQuery(specimen: Specimen): string {
	const preset = specimenFromPreset(specimen.preset);
	const parts = [`v=${SPECIMEN_VERSION}`];
	if (specimen.preset !== DEFAULT_PRESET) parts.push(`preset=${specimen.preset}`);
	if (specimen.seed !== DEFAULT_SEED) parts.push(`seed=${specimen.seed}`);
	for (const [key, entries] of byLink) {
		const values = entries.map((entry) => shortest(writtenIn(specimen, entry))).join(",");
		const before = entries.map((entry) => shortest(writtenIn(preset, entry))).join(",");
		if (values !== before) parts.push(`${key}=${values}`);
	}
	if (specimen.thinned.length > 0) parts.push(`thin=${writeThinned(specimen.thinned)}`);
	if (specimen.inputs?.m !== undefined) parts.push(`m=${specimen.inputs.m}`);
	if (specimen.inputs?.n !== undefined) parts.push(`n=${specimen.inputs.n.join(",")}`);
	return `?${parts.join("&")}`;
}

/**
 * Reads a link.
 * @param search the query, with or without its `?`
 * @param hash the fragment, with or without its `#`
 */
export async function decodeLink(search: string, hash = ""): Promise<Restored> {
	const notes = new Notes();
	const values = valuesOf(search, notes);
	const text = await grammarOf(hash, notes);
	return restored(text === undefined ? values : { ...values, grammar: text }, notes);
}

/** Reads the query alone: at once, and all there is to most links. */
export function decodeQuery(search: string): Restored {
	const notes = new Notes();
	return restored(valuesOf(search, notes), notes);
}

function restored(values: Record<string, string>, notes: Notes): Restored {
	const { specimen, notes: more } = restore(values);
	return { specimen, notes: [...notes.all(), ...more] };
}

function valuesOf(search: string, notes: Notes): Record<string, string> {
	if (search.length > LONGEST_QUERY) notes.add("link", "too long", `its first ${LONGEST_QUERY} characters are read`);
	const values = new Map<string, string>();
	for (const [key, value] of new URLSearchParams(search.slice(0, LONGEST_QUERY))) {
		if (values.has(key)) notes.add(key, "given more than once", "the last is read");
		values.set(key, value);
	}
	return Object.fromEntries(values);
}

/** Whether a fragment holds a grammar, so that the link needs `decodeLink`. */
export function hasGrammar(hash: string): boolean {
	return packedGrammar(hash) !== null;
}

function packedGrammar(hash: string): string | null {
	return new URLSearchParams(hash.replace(/^#/, "").slice(0, LONGEST_FRAGMENT)).get("g");
}

async function grammarOf(hash: string, notes: Notes): Promise<string | undefined> {
	const packed = packedGrammar(hash);
	if (packed === null) return undefined;
	if (hash.length > LONGEST_FRAGMENT) {
		notes.add("grammar", "the link is too long", "the built-in grammar is used");
		return undefined;
	}
	const text = await expandText(packed, GRAMMAR_BYTES);
	if (text === undefined) notes.add("grammar", "the link is damaged here", "the built-in grammar is used");
	return text;
}

/** Numbers as short as they can be: at most two decimals, which is all that a specimen holds. */
function shortest(value: number | string): string {
	return typeof value === "string" ? value : String(Math.round(value * 100) / 100);
}
