/**
 * Turns data from outside into a specimen: links, exported files and the command line all pass through here. Nothing is
 * refused: unusable values are replaced, with a note.
 */
import { fromPreset } from "./from_preset";
import { SEED } from "./limits";
import type { ModelSchema } from "./model_schema";
import { type Note, Notes, quote } from "./notes";
import { isRecord, readChoice, readColour, readNumber, readNumbers } from "./read_values";
import { readWithin } from "./read_within";
import { SPECIMEN_VERSION, type Specimen } from "./specimen";
import { type ParameterEntry, valueIn, writtenIn } from "./table";

export interface Restored<S extends Specimen = Specimen> {
	/** Complete and in range for any input. */
	specimen: S;
	notes: Note[];
}

/** Objects that may enclose the values: the groups of a specimen written as JSON. */
const GROUPS = ["parameters", "look"];
/** Read first, or not part of the specimen itself. */
const READ_FIRST = new Set(["v", "model", "preset"]);

/** Whether a link key or a table key has a meaning here. */
export function isKnown<S extends Specimen>({ table, details }: ModelSchema<S>, key: string): boolean {
	if (READ_FIRST.has(key) || key === "seed") return true;
	if (table.entry(key) !== undefined || table.linked(key).length > 0) return true;
	return details.some(({ keys }) => keys.includes(key));
}

/**
 * Reads a record of values by link keys (`p3: "79,76"`), table keys (`p3w: 79`), or both; values may be text or JSON
 * values, and may be inside the groups of a written specimen. Null and undefined count as absent.
 *
 * A record of an older version is converted into a current specimen with the meaning that it had.
 * @param species the schema of the specimen; a record of another model is read as far as possible
 * @param record the input; anything but an object is noted and ignored
 * @param from   the specimen with the values that the record lacks; without one, the record's preset
 */
export function restore<S extends Specimen>(species: ModelSchema<S>, record: unknown, from?: S): Restored<S> {
	const notes = new Notes();
	const parts = flatten(species, record, notes);
	const named = new Map(parts);
	// Links without a version are version 1; they name no model. A record without a single known key is no link.
	const isOld = from === undefined && !named.has("model") && parts.some(([key]) => isKnown(species, key));
	const version = readVersion(named.get("v"), isOld ? 1 : SPECIMEN_VERSION, notes);
	if (isOld && !named.has("v")) noteYounger(species, named.get("preset"), notes);
	readModel(species.name, named.get("model"), notes);
	const specimen = readPreset(species, named.get("preset"), version, from, notes);
	for (const [key, value] of parts) {
		if (!READ_FIRST.has(key)) readPart(species, specimen, key, value, notes);
	}
	for (const detail of species.details) detail.agree?.(specimen, notes);
	return { specimen, notes: notes.all() };
}

/** The model's name in a record; undefined where it has none. */
export function modelIn(record: unknown): string | undefined {
	const named = isRecord(record) && Object.hasOwn(record, "model") ? record.model : undefined;
	return typeof named === "string" ? named : undefined;
}

function flatten<S extends Specimen>({ details }: ModelSchema<S>, record: unknown, notes: Notes): [string, unknown][] {
	if (!isRecord(record)) {
		if (record !== undefined && record !== null) notes.add("specimen", `${quote(record)} is not a specimen`, "ignored");
		return [];
	}
	const groups = [...GROUPS, ...details.flatMap(({ group }) => group ?? [])];
	return Object.entries(record)
		.flatMap(([key, value]) =>
			groups.includes(key) && isRecord(value) ? Object.entries(value) : [[key, value] as const],
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

/** Notes a preset that is younger than the record's version. */
function noteYounger<S extends Specimen>({ presets }: ModelSchema<S>, value: unknown, notes: Notes): void {
	const { title, since = 1 } = (typeof value === "string" && presets.named(value)) || {};
	if (since > 1)
		notes.add(
			"v",
			`none is given, and ${title} is of version ${since}`,
			`read as version 1; v=${since} is ${title} as it is shown here`,
		);
}

function readModel(name: string, value: unknown, notes: Notes): void {
	if (value !== undefined && value !== name) notes.add("model", `${quote(value)} is not known here`, `${name} is used`);
}

/** A copy that may be written to. */
function readPreset<S extends Specimen>(
	species: ModelSchema<S>,
	value: unknown,
	version: number,
	from: S | undefined,
	notes: Notes,
): S {
	const known = typeof value === "string" && species.presets.named(value) !== undefined;
	const base = known || !from ? fromPreset(species, known ? value : undefined, version) : from;
	if (value !== undefined && !known) {
		notes.add("preset", `${quote(value)} is not a preset`, `${base.preset} is used`);
	}
	return structuredClone(base);
}

function readPart<S extends Specimen>(
	{ table, details }: ModelSchema<S>,
	specimen: S,
	key: string,
	value: unknown,
	notes: Notes,
): void {
	const detail = details.find(({ keys }) => keys.includes(key));
	const entry = table.entry(key);
	const linked = table.linked(key);
	if (key === "seed") specimen.seed = readWithin(SEED, key, value, specimen.seed, notes) ?? specimen.seed;
	else if (detail) detail.read?.(specimen, key, value, notes);
	else if (entry) readEntry(specimen, entry, key, value, notes);
	else if (linked.length === 1) readEntry(specimen, linked[0], key, value, notes);
	else if (linked.length > 1) readPoint(specimen, linked, key, value, notes);
	else notes.add(key, "not known here", "ignored");
}

function readEntry(specimen: Specimen, entry: ParameterEntry, name: string, value: unknown, notes: Notes): void {
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

/** Reads parameters that share a link key, such as a control point's `w,r`: all or none. */
function readPoint(
	specimen: Specimen,
	entries: readonly ParameterEntry[],
	key: string,
	value: unknown,
	notes: Notes,
): void {
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

function setValue(specimen: Specimen, { key, look }: ParameterEntry, value: number | string): void {
	Object.assign(look ? specimen.look : specimen.parameters, { [key]: value });
}
