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
import { messageOf } from "../locale/message_error";
import type { Message } from "../locale/texts";
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
import { text } from "./messages.generated";
import type { CommandEnvironment } from "./surroundings";
import { optionError, UsageError } from "./usage";
import { reasonOf } from "./writing";

/**
 * Returns the specimen of a call. `textName` names the file for positions in the grammar's text; XML has other lines
 * than the grammar.
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
	if (call.seed !== undefined) specimen = readTypedValues(model, seed, specimen, () => "--seed");
	specimen = readSettings(model, call.set, specimen);
	if (call.boundaryFile !== undefined) {
		const bounded = await readBoundary(model, call.boundaryFile, specimen, readFile);
		// Typed values override the mesh's own proportions.
		const start = specimen;
		specimen = readSettings(model, call.set, bounded);
		const brought = (key: string) => fieldValue(start, key) !== fieldValue(bounded, key);
		refuseIneffective(model, brought, specimen, `--boundary ${call.boundaryFile}`);
	}
	const idle = idleSettings(model, call.set, specimen);
	if (grammar !== undefined) {
		if (!model.details.some(({ packed }) => packed?.key === "grammar"))
			throw optionError(`--grammar ${call.grammarFile}`, text.message("no_text", { model: model.name }));
		specimen = readTypedValues(model, { grammar }, specimen, () => `--grammar ${call.grammarFile}`);
	}
	await refuseUnknownNames(model, call.set, specimen);
	const file = call.grammarFile ?? text("grammar_of_link");
	return {
		model,
		specimen,
		notes: [...notes, ...idle],
		textName: grammar === contents ? file : text("grammar_as_text", { file }),
	};
}

/** Returns the model that a call names, by its preset, its link or its own name; the default where it names none. */
export async function requestedModel(source: string | undefined): Promise<Model> {
	const [model] = source?.split("/") ?? [];
	const link = linkIn(source ?? "");
	return modelNamed(link ? modelInQuery(link.query) : model);
}

/** Returns the specimen that the call names; where it names none, the one of its text's file or its text's model. */
async function readStart(source: string | undefined, read: ReadText | undefined): Promise<RequestedSpecimen> {
	const model = source === undefined ? read?.model : undefined;
	return model ? { model, specimen: read?.specimen ?? fromPreset(model), notes: [] } : readSource(source);
}

/** Reads the specimen of a preset or a link; a problem of it becomes a UsageError. */
async function readSource(source: string | undefined): Promise<RequestedSpecimen> {
	return readPresetOrLink(source, text("presets_listed")).catch((error: unknown) => {
		throw error instanceof SpecimenError ? new UsageError(problemOf(error)) : error;
	});
}

/**
 * Applies `--set`. Parameters and details of the model are read first; other keys are names in the specimen's text,
 * which depends on them.
 */
function readSettings(model: Model, settings: CommandCall["set"], specimen: Specimen): Specimen {
	const isOfModel = (key: string) => detailOf(model, key) || entryOf(model, key);
	const textSettings = Object.fromEntries(Object.entries(settings).filter(([key]) => !isOfModel(key)));
	const [textName] = Object.keys(textSettings);
	const namer = model.details.find(({ named }) => named);
	if (textName !== undefined && !namer) throw optionError(`--set ${textName}`, text.message("parameter_unknown"));
	const modelSettings = Object.fromEntries(
		Object.entries(settings).filter(([key]) => !Object.hasOwn(textSettings, key)),
	);
	const option = ({ key }: SpecimenError) => `--set ${key}`;
	const read = readTypedValues(model, modelSettings, specimen, option);
	refuseFinerSteps(model, modelSettings);
	return textName === undefined ? read : readTypedValues(model, namer?.named?.(read, textSettings) ?? {}, read, option);
}

/** Refuses names that the text does not define: a note for a link, an error for a call. */
async function refuseUnknownNames(model: Model, settings: CommandCall["set"], specimen: Specimen): Promise<void> {
	const names = Object.keys(settings).filter((key) => !detailOf(model, key) && !entryOf(model, key));
	if (names.length === 0) return;
	const unknown = await model.details.find(({ unknownName }) => unknownName)?.unknownName?.(specimen, names);
	if (!unknown) return;
	const { name, problem } = unknown;
	throw optionError(`--set ${name}`, text.message("parameter_unknown_in_text", { problem: problem.text }));
}

/** Returns the parameter of a table key or a link key; the first of those that share a link key. */
const entryOf = ({ table }: Model, key: string) => table.entry(key) ?? table.linked(key)[0];

/** Returns the field that `--set` changes by that key. */
const detailOf = ({ details }: Model, key: string) =>
	details.find(({ settings = [] }) => settings.some((each) => each.split("=")[0] === key));

/**
 * Returns notes on settings that are valid, but have no effect. They are not refused, so that a series may vary the
 * procedure.
 */
function idleSettings(model: Model, settings: CommandCall["set"], specimen: Specimen): Note[] {
	const notes = new Notes();
	for (const key of Object.keys(settings)) {
		const { where = {} } = detailOf(model, key) ?? entryOf(model, key) ?? {};
		for (const [choice, needed] of Object.entries(where)) {
			const used = model.table.option(specimen, choice);
			if (needed !== used)
				notes.add(key, text.message("no_effect", { choice, used: used ?? "" }), text("set_choice", { choice, needed }));
		}
	}
	return notes.all();
}

/** Returns the value of a specimen's field by its key. */
const fieldValue = (specimen: Specimen, key: string) => (specimen as unknown as Record<string, unknown>)[key];

/**
 * Refuses an option that has no effect because of a typed choice.
 * @param brought whether the option changed the field of a key
 * @param option the option as typed, for the message
 */
function refuseIneffective(
	{ details, table }: Model,
	brought: (key: string) => boolean,
	specimen: Specimen,
	option: string,
): void {
	for (const { where = {} } of details.filter(({ keys }) => keys.some(brought))) {
		for (const [choice, needed] of Object.entries(where)) {
			const used = table.option(specimen, choice);
			if (used !== needed) throw optionError(option, text.message("choice_ignores", { choice, used: used ?? "" }));
		}
	}
}

/** Refuses typed decimals that would be rounded; those of a link are rounded silently. */
function refuseFinerSteps(model: Model, settings: CommandCall["set"]): void {
	for (const [key, value] of Object.entries(settings)) {
		const entry = entryOf(model, key);
		if (!entry || entry.kind === "colour") continue;
		const tooFine = readNumbers(value)?.find((number) => onStep(number) !== number);
		if (tooFine !== undefined)
			throw optionError(`--set ${key}`, text.message("two_decimals", { value: String(tooFine) }));
	}
}

/**
 * Reads values that a user typed; throws at the first that cannot be used as it is.
 * @param from the specimen with the other values
 * @param option names the option of a wrong value, for the message
 */
function readTypedValues(
	model: Model,
	values: Readonly<Record<string, unknown>>,
	from: Specimen,
	option: (wrong: SpecimenError) => string,
): Specimen {
	try {
		return readTyped(model, values, from);
	} catch (error) {
		throw error instanceof SpecimenError ? optionError(option(error), problemOf(error)) : error;
	}
}

/** Returns the problem of an error, without the name of the part. */
const problemOf = ({ code, args, problem }: SpecimenError): Message => ({ code, args, text: problem });

/** Reads a closed mesh as the specimen's boundary (`--boundary`). */
async function readBoundary(
	model: Model,
	path: string,
	specimen: Specimen,
	readFile: CommandEnvironment["readFile"],
): Promise<Specimen> {
	if (!model.bounded) throw optionError(`--boundary ${path}`, text.message("no_boundary", { model: model.name }));
	const bytes = await readFile(path).catch((error: unknown) => {
		throw optionError(`--boundary ${path}`, reasonOf(error));
	});
	const file = new File([Uint8Array.from(bytes)], basename(path));
	return model.bounded(specimen, file).catch((error: Error) => {
		throw optionError(`--boundary ${path}`, messageOf(error));
	});
}

/** Returns a text and its model, translated into a grammar where it has another form. */
async function readGrammarText(contents: string, file: string): Promise<ReadText> {
	try {
		return await readText(contents, file);
	} catch (error) {
		if (error instanceof TextError) throw optionError(`--grammar ${file}`, messageOf(error));
		throw error;
	}
}

/** Reads a grammar's text (`--grammar`), which must be UTF-8, not empty and not too long. */
async function readGrammar(file: string, readFile: CommandEnvironment["readFile"]): Promise<string> {
	const bytes = await readFile(file).catch((error: unknown) => {
		throw optionError(`--grammar ${file}`, reasonOf(error));
	});
	const long = fileLengthProblem(bytes.length, new TextDecoder().decode(bytes.subarray(0, 64)));
	if (long) throw optionError(`--grammar ${file}`, text.message("grammar_shorten", { problem: long.text }));
	if (bytes.every((byte) => byte <= 32)) throw optionError(`--grammar ${file}`, text.message("grammar_empty"));
	try {
		return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
	} catch {
		throw optionError(`--grammar ${file}`, text.message("grammar_not_utf8"));
	}
}
