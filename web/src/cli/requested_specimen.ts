/**
 * Turns a call into a specimen. Values of a link are changed to fit, with notes, since the link may be old or damaged;
 * typed values that do not fit are refused, since a silent change would spoil a series.
 */

import { basename } from "node:path";
import {
	linkIn,
	type Read as RequestedSpecimen,
	readSource as readPresetOrLink,
	readTyped,
	SpecimenError,
} from "../library/read_request";
import { type ReadText, readText } from "../models/for_text";
import { modelNamed } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { fileLengthProblem } from "../specimen/limits";
import { modelInQuery } from "../specimen/link";
import { type Note, Notes } from "../specimen/notes";
import { readNumbers } from "../specimen/read_values";
import type { Specimen } from "../specimen/specimen";
import { onStep } from "../specimen/table";
import { TextError } from "../specimen/text_error";
import type { CommandCall } from "./arguments";
import type { CommandEnvironment } from "./surroundings";
import { UsageError } from "./usage";
import { reasonOf } from "./writing";

/**
 * The specimen of a call. `textName` names the file for positions in the grammar's text; XML has other lines than the
 * grammar.
 * @throws UsageError
 */
export async function requestedSpecimen(
	call: CommandCall,
	{ readFile }: Pick<CommandEnvironment, "readFile">,
): Promise<RequestedSpecimen & { textName: string }> {
	const contents = call.grammarFile === undefined ? undefined : await readGrammar(call.grammarFile, readFile);
	const read = contents === undefined ? undefined : await readGrammarText(contents, call.grammarFile ?? "");
	const grammar = read?.text;
	const { model, specimen: start, notes } = await readStart(call.source, read);
	let specimen = start;
	const seed = { seed: call.seed };
	if (call.seed !== undefined) specimen = typed(model, seed, specimen, (note) => `--seed: ${note.problem}`);
	specimen = readSettings(model, call.set, specimen);
	if (call.boundaryFile !== undefined) {
		const bounded = await readBoundary(model, call.boundaryFile, specimen, readFile);
		// Typed values override the mesh's own proportions.
		const start = specimen;
		specimen = readSettings(model, call.set, bounded);
		const brought = (key: string) => held(start, key) !== held(bounded, key);
		refuseIneffective(model, brought, specimen, `--boundary ${call.boundaryFile}`);
	}
	const idle = idleSettings(model, call.set, specimen);
	if (grammar !== undefined) {
		if (!model.details.some(({ packed }) => packed?.key === "grammar"))
			throw new UsageError(`--grammar ${call.grammarFile}: the ${model.noun} is not grown by a grammar's text`);
		specimen = typed(model, { grammar }, specimen, (note) => `--grammar ${call.grammarFile}: ${note.problem}`);
	}
	await refuseUnknownNames(model, call.set, specimen);
	const file = call.grammarFile ?? "the link's grammar";
	return { model, specimen, notes: [...notes, ...idle], textName: grammar === contents ? file : `${file}, as text` };
}

/** The model that a call names, by its preset, its link or its own name; the default where it names none. */
export async function requestedModel(source: string | undefined): Promise<Model> {
	const [model] = source?.split("/") ?? [];
	const link = linkIn(source ?? "");
	return modelNamed(link ? modelInQuery(link.query) : model);
}

/** The specimen that the call names; where it names none, the one of its text's file or its text's model. */
async function readStart(source: string | undefined, read: ReadText | undefined): Promise<RequestedSpecimen> {
	const model = source === undefined ? read?.model : undefined;
	return model ? { model, specimen: read?.specimen ?? fromPreset(model), notes: [] } : readSource(source);
}

async function readSource(source: string | undefined): Promise<RequestedSpecimen> {
	return readPresetOrLink(source, "--list lists them").catch((error: unknown) => {
		throw inUsage(error, ({ message }) => message);
	});
}

function readSettings(model: Model, settings: CommandCall["set"], specimen: Specimen): Specimen {
	const known = (key: string) => detailOf(model, key) || entryOf(model, key);
	const own = Object.fromEntries(Object.entries(settings).filter(([key]) => !known(key)));
	const [stranger] = Object.keys(own);
	const namer = model.details.find(({ named }) => named);
	if (stranger !== undefined && !namer)
		throw new UsageError(`--set ${stranger}: no parameter has that key; see --help`);
	const others = Object.fromEntries(Object.entries(settings).filter(([key]) => !Object.hasOwn(own, key)));
	const message = (note: SpecimenError) => `--set ${note.key}: ${note.problem}`;
	const read = typed(model, others, specimen, message);
	refuseFinerSteps(model, others);
	return stranger === undefined ? read : typed(model, namer?.named?.(read, own) ?? {}, read, message);
}

/** Refuses names that the text does not define: a note for a link, an error for a call. */
async function refuseUnknownNames(model: Model, settings: CommandCall["set"], specimen: Specimen): Promise<void> {
	const named = Object.keys(settings).filter((key) => !detailOf(model, key) && !entryOf(model, key));
	if (named.length === 0) return;
	const stranger = await model.details.find(({ unknownName }) => unknownName)?.unknownName?.(specimen, named);
	if (stranger) throw new UsageError(`--set ${stranger.name}: no parameter has that key, and ${stranger.problem}`);
}

/** The parameter of a table key or a link key; the first of those that share a link key. */
const entryOf = ({ table }: Model, key: string) => table.entry(key) ?? table.linked(key)[0];

/** The field that --set changes by that key. */
const detailOf = ({ details }: Model, key: string) =>
	details.find(({ settings = [] }) => settings.some((each) => each.split("=")[0] === key));

/** Notes on settings that are valid, but have no effect: not refused, so that a series may vary the procedure. */
function idleSettings(model: Model, settings: CommandCall["set"], specimen: Specimen): Note[] {
	const notes = new Notes();
	for (const key of Object.keys(settings)) {
		const { where = {} } = detailOf(model, key) ?? entryOf(model, key) ?? {};
		for (const [choice, needed] of Object.entries(where)) {
			const used = model.table.option(specimen, choice);
			if (needed !== used) notes.add(key, `${choice}=${used} does not heed it`, `--set ${choice}=${needed} does`);
		}
	}
	return notes.all();
}

const held = (specimen: Specimen, key: string) => (specimen as unknown as Record<string, unknown>)[key];

/** Refuses an option that has no effect because of a typed choice. */
function refuseIneffective(
	{ details, table }: Model,
	brought: (key: string) => boolean,
	specimen: Specimen,
	option: string,
): void {
	for (const { where = {} } of details.filter(({ keys }) => keys.some(brought))) {
		for (const [choice, needed] of Object.entries(where)) {
			const used = table.option(specimen, choice);
			if (used !== needed)
				throw new UsageError(`${option}: ${choice}=${used} does not heed it; leave --set ${choice} out`);
		}
	}
}

/** Refuses typed decimals that would be rounded; those of a link are rounded silently. */
function refuseFinerSteps(model: Model, settings: CommandCall["set"]): void {
	for (const [key, value] of Object.entries(settings)) {
		const entry = entryOf(model, key);
		if (!entry || entry.kind === "colour") continue;
		const fine = readNumbers(value)?.find((number) => onStep(number) !== number);
		if (fine !== undefined) throw new UsageError(`--set ${key}: ${fine} has more than two decimals`);
	}
}

/** Reads values that a user typed; throws at the first that cannot be used as it is. */
function typed(
	model: Model,
	values: Readonly<Record<string, unknown>>,
	from: Specimen,
	message: (wrong: SpecimenError) => string,
): Specimen {
	try {
		return readTyped(model, values, from);
	} catch (error) {
		throw inUsage(error, message);
	}
}

/** Turns a SpecimenError into a UsageError; other errors stay. */
function inUsage(error: unknown, message: (wrong: SpecimenError) => string): unknown {
	return error instanceof SpecimenError ? new UsageError(message(error)) : error;
}

async function readBoundary(
	model: Model,
	path: string,
	specimen: Specimen,
	readFile: CommandEnvironment["readFile"],
): Promise<Specimen> {
	if (!model.bounded) throw new UsageError(`--boundary ${path}: the ${model.noun} has no boundary`);
	const bytes = await readFile(path).catch((error: unknown) => {
		throw new UsageError(`--boundary ${path}: ${reasonOf(error)}`);
	});
	const file = new File([Uint8Array.from(bytes)], basename(path));
	return model.bounded(specimen, file).catch((error: Error) => {
		throw new UsageError(`--boundary ${path}: ${error.message}`);
	});
}

const BEGIN =
	"begin with “axiom: F”, a flower with “#define STEM(8,0,0,0,9,3,3,1)” and “#axiom: STEM”, a tree of growth with “tree -> DivFunc(…)”, a stand with “plants 100”";

/** A text and its model, translated into a grammar where it has another form. */
async function readGrammarText(contents: string, file: string): Promise<ReadText> {
	try {
		return await readText(contents, file);
	} catch (error) {
		if (error instanceof TextError) throw new UsageError(`--grammar ${file}: ${error.message}`);
		throw error;
	}
}

async function readGrammar(file: string, readFile: CommandEnvironment["readFile"]): Promise<string> {
	const bytes = await readFile(file).catch((error: unknown) => {
		throw new UsageError(`--grammar ${file}: ${reasonOf(error)}`);
	});
	const long = fileLengthProblem(bytes.length, new TextDecoder().decode(bytes.subarray(0, 64)));
	if (long) throw new UsageError(`--grammar ${file}: ${long}; make it shorter`);
	if (bytes.every((byte) => byte <= 32)) throw new UsageError(`--grammar ${file}: is empty; ${BEGIN}`);
	try {
		return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
	} catch {
		throw new UsageError(`--grammar ${file}: not text in UTF-8`);
	}
}
