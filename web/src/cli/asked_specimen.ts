/**
 * What a call asks for → a specimen. A link is brought into range with notes, since it may be old or cut short on its
 * way; what was typed here is refused where it cannot be used, since a silent change would spoil a series.
 */

import { basename } from "node:path";
import { type Read as Asked, linkIn, readSource as readPresetOrLink, readTyped, SpecimenError } from "../library/asked";
import { type ReadText, readText } from "../models/for_text";
import { modelNamed } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { overlongFile } from "../specimen/limits";
import { modelInQuery } from "../specimen/link";
import { type Note, Notes } from "../specimen/notes";
import { readNumbers } from "../specimen/read_values";
import type { Specimen } from "../specimen/specimen";
import { onStep } from "../specimen/table";
import { TextError } from "../specimen/text_error";
import type { Call } from "./arguments";
import type { Surroundings } from "./surroundings";
import { UsageError } from "./usage";
import { reasonOf } from "./writing";

/**
 * `textName`: what places in the grammar's text are of; a file of XML has none of its lines.
 * @throws UsageError
 */
export async function askedSpecimen(
	call: Call,
	{ readFile }: Pick<Surroundings, "readFile">,
): Promise<Asked & { textName: string }> {
	const said = call.grammarFile === undefined ? undefined : await readGrammar(call.grammarFile, readFile);
	const read = said === undefined ? undefined : await readGrammarText(said, call.grammarFile ?? "");
	const grammar = read?.text;
	const { model, specimen: start, notes } = await readStart(call.source, read);
	let specimen = start;
	const seed = { seed: call.seed };
	if (call.seed !== undefined) specimen = typed(model, seed, specimen, (note) => `--seed: ${note.problem}`);
	specimen = readSettings(model, call.set, specimen);
	if (call.boundaryFile !== undefined) {
		const bounded = await readBoundary(model, call.boundaryFile, specimen, readFile);
		// The mesh's own proportions give way to what was typed.
		const start = specimen;
		specimen = readSettings(model, call.set, bounded);
		const brought = (key: string) => held(start, key) !== held(bounded, key);
		refuseUnheeded(model, brought, specimen, `--boundary ${call.boundaryFile}`);
	}
	const idle = idleSettings(model, call.set, specimen);
	if (grammar !== undefined) {
		if (!model.details.some(({ packed }) => packed?.key === "grammar"))
			throw new UsageError(`--grammar ${call.grammarFile}: the ${model.noun} is not grown by a grammar's text`);
		specimen = typed(model, { grammar }, specimen, (note) => `--grammar ${call.grammarFile}: ${note.problem}`);
	}
	await refuseStrangers(model, call.set, specimen);
	const file = call.grammarFile ?? "the link's grammar";
	return { model, specimen, notes: [...notes, ...idle], textName: grammar === said ? file : `${file}, as text` };
}

/** The model that a call names, by its preset, its link or its own name; the default where it names none. */
export async function askedModel(source: string | undefined): Promise<Model> {
	const [model] = source?.split("/") ?? [];
	const link = linkIn(source ?? "");
	return modelNamed(link ? modelInQuery(link.query) : model);
}

/** What the call names; where it names nothing, the model that its text is for, with what the text's file says of it. */
async function readStart(source: string | undefined, read: ReadText | undefined): Promise<Asked> {
	const model = source === undefined ? read?.model : undefined;
	return model ? { model, specimen: read?.specimen ?? fromPreset(model), notes: [] } : readSource(source);
}

async function readSource(source: string | undefined): Promise<Asked> {
	return readPresetOrLink(source, "--list lists them").catch((error: unknown) => {
		throw inUsage(error, ({ message }) => message);
	});
}

function readSettings(model: Model, settings: Call["set"], specimen: Specimen): Specimen {
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

/** A name that a text does not define is misspelt: of a link it is a note, of a call a mistake. */
async function refuseStrangers(model: Model, settings: Call["set"], specimen: Specimen): Promise<void> {
	const named = Object.keys(settings).filter((key) => !detailOf(model, key) && !entryOf(model, key));
	if (named.length === 0) return;
	const stranger = await model.details.find(({ stranger }) => stranger)?.stranger?.(specimen, named);
	if (stranger) throw new UsageError(`--set ${stranger.name}: no parameter has that key, and ${stranger.problem}`);
}

/** The parameter that a key of the table or of links means; the first of those that share one. */
const entryOf = ({ table }: Model, key: string) => table.entry(key) ?? table.linked(key)[0];

/** The detail that --set takes by that key. */
const detailOf = ({ details }: Model, key: string) =>
	details.find(({ settings = [] }) => settings.some((each) => each.split("=")[0] === key));

/** What was typed and is right, but nothing comes of it: not refused, so that a series may vary the procedure. */
function idleSettings(model: Model, settings: Call["set"], specimen: Specimen): Note[] {
	const notes = new Notes();
	for (const key of Object.keys(settings)) {
		const { where = {} } = detailOf(model, key) ?? entryOf(model, key) ?? {};
		for (const [choice, heeding] of Object.entries(where)) {
			const used = model.table.option(specimen, choice);
			if (heeding !== used) notes.add(key, `${choice}=${used} does not heed it`, `--set ${choice}=${heeding} does`);
		}
	}
	return notes.all();
}

const held = (specimen: Specimen, key: string) => (specimen as unknown as Record<string, unknown>)[key];

/** What came in by an option, but nothing would come of it, since a choice that was typed does not heed it. */
function refuseUnheeded(
	{ details, table }: Model,
	brought: (key: string) => boolean,
	specimen: Specimen,
	option: string,
): void {
	for (const { where = {} } of details.filter(({ keys }) => keys.some(brought))) {
		for (const [choice, heeding] of Object.entries(where)) {
			const used = table.option(specimen, choice);
			if (used !== heeding)
				throw new UsageError(`${option}: ${choice}=${used} does not heed it; leave --set ${choice} out`);
		}
	}
}

/** A link's further decimals are rounded without a word; someone who types them means them. */
function refuseFinerSteps(model: Model, settings: Call["set"]): void {
	for (const [key, value] of Object.entries(settings)) {
		const entry = entryOf(model, key);
		if (!entry || entry.kind === "colour") continue;
		const fine = readNumbers(value)?.find((number) => onStep(number) !== number);
		if (fine !== undefined) throw new UsageError(`--set ${key}: ${fine} has more than two decimals`);
	}
}

/** Reads values that a person typed: the first that cannot be used as it is ends it. */
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

/** What is wrong with what was typed, as a mistake in the call; all else stays what it is. */
function inUsage(error: unknown, message: (wrong: SpecimenError) => string): unknown {
	return error instanceof SpecimenError ? new UsageError(message(error)) : error;
}

async function readBoundary(
	model: Model,
	path: string,
	specimen: Specimen,
	readFile: Surroundings["readFile"],
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

/** A text and the model that it is for; one that is in another form than its model's grammars, as one of those. */
async function readGrammarText(said: string, file: string): Promise<ReadText> {
	try {
		return await readText(said, file);
	} catch (error) {
		if (error instanceof TextError) throw new UsageError(`--grammar ${file}: ${error.message}`);
		throw error;
	}
}

async function readGrammar(file: string, readFile: Surroundings["readFile"]): Promise<string> {
	const bytes = await readFile(file).catch((error: unknown) => {
		throw new UsageError(`--grammar ${file}: ${reasonOf(error)}`);
	});
	const long = overlongFile(bytes.length, new TextDecoder().decode(bytes.subarray(0, 64)));
	if (long) throw new UsageError(`--grammar ${file}: ${long}; make it shorter`);
	if (bytes.every((byte) => byte <= 32)) throw new UsageError(`--grammar ${file}: is empty; ${BEGIN}`);
	try {
		return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
	} catch {
		throw new UsageError(`--grammar ${file}: not text in UTF-8`);
	}
}
