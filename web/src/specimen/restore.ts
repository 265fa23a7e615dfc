/**
 * Turns data from outside into a specimen: links, exported files and the command line all pass through here. Nothing is
 * refused: unusable values are replaced, with a note.
 */
import { fromPreset } from "./from_preset";
import { SEED } from "./limits";
import { text } from "./messages.generated";
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

/** Returns whether a key of a link or a file has a meaning for this model. */
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
 * @param schema the schema of the specimen; a record of another model is read as far as possible
 * @param record the input; anything but an object is noted and ignored
 * @param from   the specimen with the values that the record lacks; without one, the record's preset
 */
export function restore<S extends Specimen>(schema: ModelSchema<S>, record: unknown, from?: S): Restored<S> {
	const notes = new Notes();
	const parts = flatten(schema, record, notes);
	const named = new Map(parts);
	// Links without a version are version 1; they name no model. A record without a single known key is no link.
	const isOld = from === undefined && !named.has("model") && parts.some(([key]) => isKnown(schema, key));
	const version = readVersion(named.get("v"), isOld ? 1 : SPECIMEN_VERSION, notes);
	if (isOld && !named.has("v")) noteYounger(schema, named.get("preset"), notes);
	readModel(schema.name, named.get("model"), notes);
	const specimen = readPreset(schema, named.get("preset"), version, from, notes);
	for (const [key, value] of parts) {
		if (!READ_FIRST.has(key)) readPart(schema, specimen, key, value, notes);
	}
	for (const detail of schema.details) detail.agree?.(specimen, notes);
	return { specimen, notes: notes.all() };
}

/** Returns the model's name in a record; undefined where it has none. */
export function modelIn(record: unknown): string | undefined {
	const named = isRecord(record) && Object.hasOwn(record, "model") ? record.model : undefined;
	return typeof named === "string" ? named : undefined;
}

/**
 * Lists the values of a record by key: groups are resolved, absent values left out. Anything but an object is noted and
 * has no values.
 */
function flatten<S extends Specimen>({ details }: ModelSchema<S>, record: unknown, notes: Notes): [string, unknown][] {
	if (!isRecord(record)) {
		if (record !== undefined && record !== null)
			notes.add("specimen", text.message("not_a_specimen", { value: quote(record) }), text("ignored"));
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

/**
 * Reads the version.
 * @param silent the version of a record without one
 */
function readVersion(value: unknown, silent: number, notes: Notes): number {
	if (value === undefined) return silent;
	const version = readNumber(value);
	if (version === undefined || !Number.isInteger(version) || version < 1) {
		notes.add("v", text.message("not_a_version", { value: quote(value) }), text("read_as_version_1"));
		return 1;
	}
	if (version > SPECIMEN_VERSION) {
		notes.add("v", text.message("newer_version", { version: String(version) }), text("known_parts_read"));
	}
	return version;
}

/** Adds a note where the preset is younger than the record's version. */
function noteYounger<S extends Specimen>({ presets }: ModelSchema<S>, value: unknown, notes: Notes): void {
	const { title: preset = "", since = 1 } = (typeof value === "string" && presets.named(value)) || {};
	const version = String(since);
	if (since > 1)
		notes.add("v", text.message("version_missing", { preset, version }), text("read_as_older", { preset, version }));
}

/**
 * Adds a note where a record is of another model; the schema's own model is used in any case.
 * @param name the schema's model
 */
function readModel(name: string, value: unknown, notes: Notes): void {
	if (value !== undefined && value !== name)
		notes.add("model", text.message("unknown_model", { value: quote(value) }), text("used", { value: name }));
}

/** Returns a specimen that may be changed: a copy of the record's preset or, without one, of `from`. */
function readPreset<S extends Specimen>(
	schema: ModelSchema<S>,
	value: unknown,
	version: number,
	from: S | undefined,
	notes: Notes,
): S {
	const known = typeof value === "string" && schema.presets.named(value) !== undefined;
	const base = known || !from ? fromPreset(schema, known ? value : undefined, version) : from;
	if (value !== undefined && !known) {
		notes.add("preset", text.message("unknown_preset", { value: quote(value) }), text("used", { value: base.preset }));
	}
	return structuredClone(base);
}

/**
 * Reads one value from outside into a specimen: the seed, a detail, or one or several linked parameters. Notes an
 * unknown key.
 */
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
	if (key === "seed") specimen.seed = readSeed(key, value, specimen.seed, notes);
	else if (detail) detail.read?.(specimen, key, value, notes);
	else if (entry) readEntry(specimen, entry, key, value, notes);
	else if (linked.length === 1) readEntry(specimen, linked[0], key, value, notes);
	else if (linked.length > 1) readPoint(specimen, linked, key, value, notes);
	else notes.add(key, text.message("unknown_key"), text("ignored"));
}

/** Reads a seed; notes an unusable one, and returns `before` in its place. */
function readSeed(key: string, value: unknown, before: number, notes: Notes): number {
	return readWithin(SEED, key, value, text("used", { value: String(before) }), notes) ?? before;
}

/**
 * Reads a parameter; an unusable value is noted, and the specimen's value stays.
 * @param name the key that the record uses, for notes
 */
function readEntry(specimen: Specimen, entry: ParameterEntry, name: string, value: unknown, notes: Notes): void {
	const otherwise = text("used", { value: String(writtenIn(specimen, entry)) });
	if (entry.kind === "colour") {
		const colour = readColour(value);
		if (colour !== undefined) setValue(specimen, entry, colour);
		else notes.add(name, text.message("not_a_colour", { value: quote(value) }), otherwise);
	} else if (entry.kind === "choice") {
		const choice = readChoice(value, entry.options);
		if (choice !== undefined) setValue(specimen, entry, choice);
		else {
			const options = entry.options.join(", ");
			notes.add(name, text.message("not_an_option", { value: quote(value), options }), otherwise);
		}
	} else {
		const number = readWithin(entry, name, value, otherwise, notes);
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
		const wanted = { value: quote(value), count: entries.length, example: "79,76" };
		notes.add(key, text.message("not_numbers", wanted), text("used", { value: used }));
		return;
	}
	entries.forEach((entry, slot) => {
		readEntry(specimen, entry, key, numbers[slot], notes);
	});
}

/** Sets a parameter in the specimen, in place. */
function setValue(specimen: Specimen, { key, look }: ParameterEntry, value: number | string): void {
	Object.assign(look ? specimen.look : specimen.parameters, { [key]: value });
}
