/**
 * The one door by which data from outside becomes a specimen: links, exported files and the command line all enter
 * here. Nothing is refused: what cannot be used is replaced, and a note says so.
 */

import { presetNamed } from "../models/bunch/presets/index";
import { specimenFromPreset } from "./from_preset";
import { GRAMMAR_BYTES, INPUT_M, INPUT_N, INPUT_N_LENGTH, SEED } from "./limits";
import { type Note, Notes, quote } from "./notes";
import { isRecord, readChoice, readColour, readList, readNumber, readNumbers } from "./read_values";
import { SPECIMEN_VERSION, type Specimen } from "./specimen";
import {
	type ChoiceEntry,
	type ColourEntry,
	type Entry,
	entriesOfLink,
	entryOf,
	inGap,
	isLook,
	type NumberEntry,
	nearestWithin,
	type Range,
	valueIn,
	writtenIn,
} from "./table";
import { readThinned } from "./thinned";

export interface Restored {
	/** Complete and in range, whatever came in. */
	specimen: Specimen;
	notes: Note[];
}

/** What may surround the values: the groups of a specimen written as JSON. */
const GROUPS = ["parameters", "look", "inputs"];
/** Read before, or not of the specimen itself. */
const READ_FIRST = new Set(["v", "model", "preset"]);
/** What a specimen holds besides the parameters of the table. */
const OWN_KEYS = new Set([...READ_FIRST, "seed", "thin", "thinned", "m", "n", "grammar"]);

/** Whether a key of a link or a table key means something here. */
export function isKnown(key: string): boolean {
	return OWN_KEYS.has(key) || entryOf(key) !== undefined || entriesOfLink(key).length > 0;
}

/**
 * Reads a record of values by link keys (`p3: "79,76"`), table keys (`p3w: 79`), or both; values may be text or JSON's
 * own, and may stand in the groups of a written specimen. Null and undefined are absent.
 *
 * A record of an older version gives what it meant then, as a specimen of now.
 *
 * @param record what came in; anything but an object is noted and passed over
 * @param from   the specimen whose values hold where the record is silent; without one, the record's preset
 */
export function restore(record: unknown, from?: Specimen): Restored {
	const notes = new Notes();
	const parts = flatten(record, notes);
	const named = new Map(parts);
	// Links from before versions were written are version 1; what says nothing of a specimen is no link.
	const isLink = from === undefined && parts.some(([key]) => isKnown(key));
	const version = readVersion(named.get("v"), isLink ? 1 : SPECIMEN_VERSION, notes);
	readModel(named.get("model"), notes);
	const specimen = readPreset(named.get("preset"), version, from, notes);
	for (const [key, value] of parts) {
		if (!READ_FIRST.has(key)) readPart(specimen, key, value, notes);
	}
	matchInputs(specimen, notes);
	orderRadii(specimen, notes);
	return { specimen, notes: notes.all() };
}

function flatten(record: unknown, notes: Notes): [string, unknown][] {
	if (!isRecord(record)) {
		if (record !== undefined && record !== null) notes.add("specimen", `${quote(record)} is not a specimen`, "ignored");
		return [];
	}
	return Object.entries(record)
		.flatMap(([key, value]) =>
			GROUPS.includes(key) && isRecord(value) ? Object.entries(value) : [[key, value] as const],
		)
		.filter(([, value]) => value !== undefined && value !== null)
		.map(([key, value]) => [key, value]);
}

function readVersion(value: unknown, silent: number, notes: Notes): number {
	if (value === undefined) return silent;
	const version = readNumber(value);
	if (version === undefined || !Number.isInteger(version) || version < 1) {
		notes.add("v", `${quote(value)} is not a version`, "read as version 1");
		return 1;
	}
	if (version > SPECIMEN_VERSION) {
		notes.add("v", `made by a newer version (${version})`, "read as far as it is known here");
	}
	return version;
}

function readModel(value: unknown, notes: Notes): void {
	if (value !== undefined && value !== "bunch")
		notes.add("model", `${quote(value)} is not known here`, "bunch is used");
}

/** A copy that may be written to. */
function readPreset(value: unknown, version: number, from: Specimen | undefined, notes: Notes): Specimen {
	const known = typeof value === "string" && presetNamed(value) !== undefined;
	const base = known || !from ? specimenFromPreset(known ? value : undefined, version) : from;
	if (value !== undefined && !known) {
		notes.add("preset", `${quote(value)} is not a preset`, `${base.preset} is used`);
	}
	return { ...base, parameters: { ...base.parameters }, look: { ...base.look }, thinned: [...base.thinned] };
}

function readPart(specimen: Specimen, key: string, value: unknown, notes: Notes): void {
	const entry = entryOf(key);
	const linked = entriesOfLink(key);
	if (key === "seed") specimen.seed = readWithin(SEED, key, value, specimen.seed, notes) ?? specimen.seed;
	else if (key === "grammar") readGrammar(specimen, value, notes);
	else if (key === "thin" || key === "thinned") specimen.thinned = readThinned(key, value, notes);
	else if (key === "m" || key === "n") readInput(specimen, key, value, notes);
	else if (entry) readEntry(specimen, entry, key, value, notes);
	else if (linked.length > 0) readPoint(specimen, linked, key, value, notes);
	else notes.add(key, "not known here", "ignored");
}

function readEntry(specimen: Specimen, entry: Entry, name: string, value: unknown, notes: Notes): void {
	const before = writtenIn(specimen, entry);
	if (entry.kind === "colour") {
		const colour = readColour(value);
		if (colour !== undefined) setValue(specimen, entry, colour);
		else notes.add(name, `${quote(value)} is not a colour of six hexadecimal digits`, `${before} is used`);
	} else if (entry.kind === "choice") {
		const choice = readChoice(value, entry.options);
		if (choice !== undefined) setValue(specimen, entry, choice);
		else notes.add(name, `${quote(value)} is none of ${entry.options.join(", ")}`, `${before} is used`);
	} else {
		const number = readWithin(entry, name, value, before, notes);
		if (number !== undefined) setValue(specimen, entry, number);
	}
}

/** A control point, `w,r`: both or none. */
function readPoint(specimen: Specimen, entries: readonly Entry[], key: string, value: unknown, notes: Notes): void {
	const numbers = readNumbers(value);
	if (numbers?.length !== entries.length) {
		const used = entries.map((entry) => valueIn(specimen, entry)).join(",");
		notes.add(key, `${quote(value)} is not ${entries.length} numbers like “79,76”`, `${used} is used`);
		return;
	}
	entries.forEach((entry, slot) => {
		readEntry(specimen, entry, key, numbers[slot], notes);
	});
}

/** The number that fits the range, noted where it is not the one given; undefined where there is none. */
function readWithin(range: Range, key: string, value: unknown, before: unknown, notes: Notes): number | undefined {
	const number = readNumber(value);
	if (number === undefined) {
		notes.add(key, `${quote(value)} is not a number`, `${before} is used`);
		return undefined;
	}
	const used = nearestWithin(range, number);
	const problem = misfit(range, number);
	if (problem) notes.add(key, problem, `${used} is used`);
	return used;
}

function misfit(range: Range, number: number): string | undefined {
	const { kind, min, max, gapBelow } = range;
	if (number < min) return `${number} is below the least value, ${min}`;
	if (number > max) return `${number} is above the greatest value, ${max}`;
	if (kind === "integer" && !Number.isInteger(number)) return `${number} is not a whole number`;
	return inGap(range, number) ? `${number} lies between 0 and ${gapBelow}, where nothing is` : undefined;
}

function readInput(specimen: Specimen, key: "m" | "n", value: unknown, notes: Notes): void {
	if (key === "m") {
		const m = readWithin(INPUT_M, key, value, "the profile's", notes);
		if (m !== undefined) specimen.inputs = { ...specimen.inputs, m };
		return;
	}
	const given = readList(value);
	const n = readNumbers(given.slice(0, INPUT_N_LENGTH));
	if (!n || n.length === 0) {
		notes.add(key, `${quote(value)} is not a list of numbers like “1,2”`, "the profile's is used");
		return;
	}
	if (given.length > n.length) notes.add(key, `${given.length} values are too many`, `the first ${n.length} are used`);
	specimen.inputs = { ...specimen.inputs, n: n.map((each) => readWithin(INPUT_N, key, each, 0, notes) ?? 0) };
}

/** The grammar reads n₁ … n₍m−1₎: `n` alone says what m is, and one of another length than m asks for is of no use. */
function matchInputs(specimen: Specimen, notes: Notes): void {
	const { m, n } = specimen.inputs ?? {};
	if (!n) return;
	if (m === undefined) specimen.inputs = { m: n.length + 1, n };
	else if (n.length !== m - 1) {
		notes.add(
			"n",
			`m = ${m} needs ${m - 1} ${m === 2 ? "value" : "values"}, not ${n.length}`,
			"the profile's are used",
		);
		specimen.inputs = { m };
	}
}

function readGrammar(specimen: Specimen, value: unknown, notes: Notes): void {
	const problem = typeof value === "string" ? oversize(value) : `${quote(value)} is not text`;
	if (problem)
		notes.add("grammar", problem, specimen.grammar ? "the one before is used" : "the built-in grammar is used");
	else if (value === "") delete specimen.grammar;
	else specimen.grammar = wellFormed(value as string);
}

function oversize(text: string): string | undefined {
	const bytes = text.length > GRAMMAR_BYTES ? text.length : new TextEncoder().encode(text).length;
	return bytes > GRAMMAR_BYTES ? `longer than ${GRAMMAR_BYTES / 1024} KiB` : undefined;
}

/** Half a surrogate pair has no UTF-8, so no link or request could carry it. */
function wellFormed(text: string): string {
	return new TextDecoder("utf-8", { ignoreBOM: true }).decode(new TextEncoder().encode(text));
}

function orderRadii(specimen: Specimen, notes: Notes): void {
	const { rmin, rmax } = specimen.parameters;
	if (rmin <= rmax) return;
	notes.add("rmin", `${rmin} is above rmax, ${rmax}`, "the two are swapped");
	specimen.parameters.rmin = rmax;
	specimen.parameters.rmax = rmin;
}

function setValue(specimen: Specimen, entry: NumberEntry | ChoiceEntry, value: number): void;
function setValue(specimen: Specimen, entry: ColourEntry, value: string): void;
function setValue(specimen: Specimen, entry: Entry, value: number | string): void {
	if (isLook(entry.key)) Object.assign(specimen.look, { [entry.key]: value });
	else Object.assign(specimen.parameters, { [entry.key]: value });
}
