/** The command: grows one specimen of any model and writes it. */
import { aimed } from "../batch/aimed";
import { literalDraws } from "../batch/draws";
import { aimsOf } from "../batch/goals";
import { CoreCache } from "../core/cores";
import { CoreError } from "../core/errors";
import { EmptyPlantError, FileTooLargeError } from "../formats/file_error";
import { FORMS, plantFile } from "../formats/plant_files";
import { agedOf, hasAges } from "../generate/files/aged";
import { levelledOf } from "../generate/files/levelled";
import { growPlant } from "../generate/growth";
import { messageOf } from "../locale/message_error";
import { catalogue } from "../models/catalogue";
import { modelNames } from "../models/index";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { changesInWords, growthsInWords, reachedInWords } from "../targets/words";
import { type CommandCall, readArguments } from "./arguments";
import { refuseUnused } from "./file_options";
import { text } from "./messages.generated";
import { endingOf, endingsOf, jsonOf, outputFiles, ownFormat } from "./outputs";
import { printable } from "./printable";
import { requestedModel, requestedSpecimen } from "./requested_specimen";
import { growSeries } from "./series";
import type { CommandEnvironment } from "./surroundings";
import { readTargets } from "./targets";
import { TimeLimit, TimeOverError } from "./time_limit";
import { CUT_SHORT, MISSED, optionError, TIME_OVER, UsageError, usage } from "./usage";
import { writing } from "./writing";

/**
 * Runs the command: prints the help or a list, or grows a plant or a series. Errors are printed.
 * @returns the exit status: 0 grown, 1 the core crashed or is missing, a file could not be written or some plants of a
 * series did not grow, 2 the call cannot be used, 3 grown but a target is missed, 4 the plant is empty and the file
 * cannot be, 5 the time limit was reached, 6 a limit of the core cut the plant short
 */
export async function run(words: readonly string[], surroundings: CommandEnvironment): Promise<number> {
	const world = { ...surroundings, printError: (line: string) => surroundings.printError(printable(line)) };
	try {
		const call = readArguments(words);
		if (call.help) world.print(usage(await requestedModel(call.source), modelNames()));
		else if (call.list) world.print(`${JSON.stringify(await catalogue())}\n`);
		else {
			const limit = new TimeLimit(call.seconds, world.elapsed);
			if (call.batch) return await growSeries(call, call.batch, limit, world);
			return await growAndWrite(call, limit, world);
		}
		return 0;
	} catch (error) {
		const problem = messageOf(error).text.replaceAll("\n", " ");
		world.printError(`${text("error", { problem })}${error instanceof UsageError ? error.below : ""}`);
		if (error instanceof EmptyPlantError) return 4;
		if (error instanceof TimeOverError) return TIME_OVER;
		return error instanceof UsageError || error instanceof FileTooLargeError ? 2 : 1;
	}
}

/**
 * Grows one plant, at its targets if there are any, and writes its files or prints its JSON.
 * @returns the exit status: 0 grown, 3 grown but a target is missed, 5 or 6 cut short by the time limit or a limit of
 * the core
 */
async function growAndWrite(call: CommandCall, limit: TimeLimit, world: CommandEnvironment): Promise<number> {
	const { model, specimen: from, notes, textName } = await requestedSpecimen(call, world);
	const goals = readTargets(model, from, call.targets);
	const aims = aimsOf(model.table, goals, literalDraws(), from.seed);
	const out = call.out ?? defaultFile(call.form, from);
	const ending = out === undefined ? "json" : endingOf(model, out);
	if (out?.toLowerCase().endsWith(".png")) throw optionError(`--out ${out}`, text.message("no_pictures"));
	if (ending === undefined)
		throw optionError(`--out ${out}`, text.message("ending_unknown", { endings: endingsOf(model) }));
	await checkForm({ ...call, out }, ending, model, from);
	refuseUnused(call.files, [plantFile(ending, call.form)?.key ?? ending]);
	checkTraceable(call, model, ending);
	const cores = new CoreCache((wasm) => world.loadCore(wasm, limit.passed));
	const run = cores.grow.bind(cores);
	// Compute only data that the file holds: levels and ages are grown by themselves.
	const json = ending === "json";
	const { life, levelled } = plantFile(ending, call.form) ?? {};
	const [meshes, measures] = [
		!(json || life || levelled),
		json || plantFile(ending)?.form !== undefined || ownFormat(model, ending)?.measured === true,
	];
	const ownText = "grammar" in from && typeof from.grammar === "string" ? from.grammar : undefined;
	const grow = (each: Specimen, wanted: GrowthOptions) =>
		withGrammarErrors(
			ownText === undefined ? undefined : { name: textName, text: ownText },
			limit.orNothing(growPlant(model, each, wanted, run, { timeIsOver: limit.isOver })),
		);
	// A cut plant would mislead a search, and would be a gap in an animation.
	const growWhole = (each: Specimen, wanted: GrowthOptions) => limit.whole(() => grow(each, wanted));
	const { specimen, missed } =
		aims.length > 0 ? await searchForTargets(model, from, aims, growWhole, world) : { specimen: from, missed: false };
	const { string, trace } = call;
	const grown = await grow(specimen, {
		meshes,
		measures,
		...(string ? { string } : {}),
		...(trace && { trace }),
	});
	const status = statusOf(grown, missed);
	const annotated: Plant = { ...grown, notes: [...new Set([...grown.notes, ...notes.map((note) => note.text)])] };
	if (out === undefined) {
		for (const piece of jsonOf(model, annotated, specimen)) world.print(piece);
		reportTime(grown, limit, world);
		return status;
	}
	const growOther = (other: Specimen, wanted?: GrowthOptions) => growWhole(other, { measures: false, ...wanted });
	const fileNotes: string[] = [];
	const further = {
		aged: agedOf(model, specimen, growOther),
		levels: levelledOf(model, specimen, growOther),
		note: (note: string) => void fileNotes.push(note),
	};
	const options = { ...call.files, form: call.form };
	for (const [file, data] of await outputFiles(out, ending, model, annotated, specimen, options, further)) {
		await writing(file, () => world.writeFile(file, data));
	}
	for (const note of new Set([...annotated.notes, ...fileNotes])) world.printError(text("note", { note }));
	reportTime(grown, limit, world);
	return status;
}

/** Returns the exit status of a plant that is written: a cut plant is reported before a missed target. */
function statusOf({ cutShort }: Plant, missed: boolean): number {
	if (cutShort) return cutShort === "time" ? TIME_OVER : CUT_SHORT;
	return missed ? MISSED : 0;
}

/** Reports that the time limit cut the plant short. */
function reportTime({ cutShort }: Plant, { option }: TimeLimit, { printError }: CommandEnvironment): void {
	if (cutShort !== "time") return;
	printError(text("error", { problem: text("at_option", { option, problem: text("time_cut") }) }));
}

/**
 * Checks that the requested string or trace can be written.
 * @throws UsageError where the string or a trace is requested for a plant or a file that has none
 */
function checkTraceable(call: CommandCall, model: Model, ending: string): void {
	const hasText = model.details.some(({ packed }) => packed?.key === "grammar");
	const modelArguments = { model: model.name };
	if (call.string && !(model.strings && ending === "json")) {
		const missing = text.message(hasText ? "no_string" : "no_text", modelArguments);
		throw optionError("--string", model.strings ? text.message("string_in_json") : missing);
	}
	if (call.trace && !(model.traces && ending === "json")) {
		const missing = text.message(hasText ? "no_trace" : "no_text", modelArguments);
		throw optionError("--chronicle", model.traces ? text.message("trace_in_json") : missing);
	}
}

/** Returns the specimen nearest to its targets, and whether it misses one; reports the results and changes. */
async function searchForTargets(
	model: Model,
	from: Specimen,
	aims: readonly Aim[],
	grow: (specimen: Specimen, wanted: GrowthOptions) => Promise<Plant>,
	{ printError }: CommandEnvironment,
): Promise<{ specimen: Specimen; missed: boolean }> {
	const answer = await aimed(model, from, aims, (each) => grow(each, { meshes: false, measures: true }));
	for (const each of answer.reached) printError(text("target", { result: reachedInWords(each) }));
	const changes = changesInWords(model, from, answer.specimen);
	if (changes) printError(text("target_changes", { changes, tries: growthsInWords(answer) }));
	return { specimen: answer.specimen, missed: answer.reached.some(({ isReached }) => !isReached) };
}

/** Returns the name of a file that a form alone determines: `oak-7-game.zip`; undefined for forms of several endings. */
function defaultFile(form: string | undefined, { preset, seed }: Specimen): string | undefined {
	return form === "game" ? `${preset}-${seed}-game.zip` : undefined;
}

/**
 * Checks that the requested form of the file exists for the plant.
 * @throws UsageError where there is no such form of the file, or the plant has no ages or levels for it
 */
async function checkForm({ form, out }: CommandCall, ending: string, model: Model, specimen: Specimen): Promise<void> {
	const file = plantFile(ending, form);
	if (file?.life) await model.prepare?.(specimen);
	if (file?.life && !hasAges(model, specimen)) throw optionError(`--form ${form}`, text.message("no_ages"));
	if (file?.levelled && !model.levels)
		throw optionError(`--form ${form}`, text.message("no_levels", { model: model.name }));
	if (form === undefined || file) return;
	const endingHasForms = out !== undefined && plantFile(ending)?.form !== undefined;
	const forms = text.message("forms", { forms: FORMS.join(", ") });
	throw optionError(`--form ${form}`, endingHasForms ? forms : text.message("forms_of_glb"));
}

/**
 * Turns errors of the core into errors of the call; a position in the grammar is reported as compilers do, with its
 * line.
 * @param grammar the text and its name in messages: its file; undefined for the built-in one
 */
async function withGrammarErrors(
	grammar: { name: string; text: string } | undefined,
	grown: Promise<Plant>,
): Promise<Plant> {
	try {
		return await grown;
	} catch (error) {
		if (!(error instanceof CoreError)) throw error;
		const { reason, line, column } = error;
		const message = messageOf(error);
		const ofGrammar = grammar !== undefined && reason !== "bad request" && reason !== "bad input";
		if (!ofGrammar) throw new UsageError(message);
		const place = { file: grammar.name, problem: message.text };
		const placed =
			line > 0 ? text("at_place", { ...place, line: String(line), column: String(column) }) : text("at_file", place);
		throw new UsageError({ ...message, text: placed }, quotedLine(grammar.text, line, column));
	}
}

/** Returns the line of a text below the message, and a mark below the position; empty where there is none. */
function quotedLine(grammar: string, line: number, column: number): string {
	const quoted = grammar.split("\n")[line - 1]?.trimEnd();
	if (!quoted) return "";
	const before = Array.from(quoted).slice(0, column - 1);
	return `\n  ${quoted}\n  ${before.map((letter) => (letter === "\t" ? "\t" : " ")).join("")}^`;
}
