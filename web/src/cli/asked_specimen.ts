/**
 * What a call asks for → a specimen. A link is brought into range with notes, since it may be old or cut short on its
 * way; what was typed here is refused where it cannot be used, since a silent change would spoil a series.
 */

import { BUNCH, specimenFromPreset } from "../models/bunch/species";
import type { BunchSpecimen as Specimen } from "../models/bunch/specimen";
import { GRAMMAR_BYTES } from "../specimen/limits";
import { decodeLink } from "../specimen/link";
import { type Note, Notes } from "../specimen/notes";
import { readNumbers } from "../specimen/read_values";
import { type Restored, restore } from "../specimen/restore";
import { onStep } from "../specimen/table";
import type { Call } from "./arguments";
import type { Surroundings } from "./surroundings";
import { UsageError } from "./usage";

/** @throws UsageError */
export async function askedSpecimen(
	call: Call,
	{ readFile }: Pick<Surroundings, "readFile">,
): Promise<Restored<Specimen>> {
	const { specimen: start, notes } = await readSource(call.source);
	let specimen = start;
	if (call.seed !== undefined) specimen = typed({ seed: call.seed }, specimen, (note) => `--seed: ${note.problem}`);
	specimen = readSettings(call.set, specimen);
	const idle = idleSettings(call.set, specimen);
	if (call.grammarFile !== undefined) {
		specimen = { ...specimen, grammar: await readGrammar(call.grammarFile, readFile) };
	}
	return { specimen, notes: [...notes, ...idle] };
}

async function readSource(source: string | undefined): Promise<Restored<Specimen>> {
	if (source === undefined || BUNCH.presets.named(source)) return { specimen: specimenFromPreset(source), notes: [] };
	const query = source.indexOf("?");
	const hash = source.indexOf("#");
	const end = hash < 0 ? source.length : hash;
	if (query >= 0 && query < end) return decodeLink(BUNCH, source.slice(query, end), source.slice(end));
	if (hash >= 0 || source.includes("://")) return decodeLink(BUNCH, "", source.slice(end));
	throw new UsageError(`“${source}” is neither a preset nor a link; --help lists the presets`);
}

function readSettings(settings: Call["set"], specimen: Specimen): Specimen {
	for (const key of Object.keys(settings)) {
		const known = detailOf(key) || entryOf(key);
		if (!known) throw new UsageError(`--set ${key}: no parameter has that key; see --help`);
	}
	const read = typed(settings, specimen, (note) => `--set ${note.key}: ${note.problem}`);
	refuseFinerSteps(settings);
	return read;
}

/** The parameter that a key of the table or of links means; the first of those that share one. */
const entryOf = (key: string) => BUNCH.table.entry(key) ?? BUNCH.table.linked(key)[0];

/** The detail that --set takes by that key. */
const detailOf = (key: string) =>
	BUNCH.details.find(({ settings = [] }) => settings.some((each) => each.split("=")[0] === key));

/** What was typed and is right, but nothing comes of it: not refused, so that a series may vary the procedure. */
function idleSettings(settings: Call["set"], specimen: Specimen): Note[] {
	const notes = new Notes();
	for (const key of Object.keys(settings)) {
		const { where = {} } = detailOf(key) ?? entryOf(key) ?? {};
		for (const [choice, heeding] of Object.entries(where)) {
			const used = BUNCH.table.option(specimen, choice);
			if (heeding !== used) notes.add(key, `${choice}=${used} does not heed it`, `--set ${choice}=${heeding} does`);
		}
	}
	return notes.all();
}

/** A link's further decimals are rounded without a word; someone who types them means them. */
function refuseFinerSteps(settings: Call["set"]): void {
	for (const [key, value] of Object.entries(settings)) {
		if (!entryOf(key) || entryOf(key)?.kind === "colour") continue;
		const fine = readNumbers(value)?.find((number) => onStep(number) !== number);
		if (fine !== undefined) throw new UsageError(`--set ${key}: ${fine} has more than two decimals`);
	}
}

/** Reads values that a person typed: the first that cannot be used as it is ends it. */
function typed(values: Readonly<Record<string, string>>, from: Specimen, message: (note: Note) => string): Specimen {
	const { specimen, notes } = restore(BUNCH, values, from);
	if (notes.length > 0) throw new UsageError(message(notes[0]));
	return specimen;
}

async function readGrammar(file: string, readFile: Surroundings["readFile"]): Promise<string> {
	const bytes = await readFile(file).catch((error: unknown) => {
		throw new UsageError(`--grammar ${file}: ${reasonOf(error)}`);
	});
	if (bytes.length > GRAMMAR_BYTES) throw new UsageError(`--grammar ${file}: longer than ${GRAMMAR_BYTES / 1024} KiB`);
	if (bytes.length === 0) throw new UsageError(`--grammar ${file}: is empty`);
	try {
		return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
	} catch {
		throw new UsageError(`--grammar ${file}: not text in UTF-8`);
	}
}

/** The system's word on a file, in plain ones. */
export function reasonOf(error: unknown): string {
	const { code, message } = error as NodeJS.ErrnoException;
	if (code === "ENOENT") return "no such file or folder";
	if (code === "EISDIR") return "is a folder";
	if (code === "EACCES" || code === "EPERM" || code === "EROFS") return "not allowed";
	return message.split("\n")[0];
}
