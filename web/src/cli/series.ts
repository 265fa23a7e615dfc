/**
 * Grows a series into a folder: a file for each plant, a table of them and a manifest. Complete plants are not grown
 * again: rows are in a journal beside the table, which is renamed to the table once it is complete. A folder holds one
 * series, and one process writes a table.
 */
import { join } from "node:path";
import { independentDraws, literalDraws } from "../batch/draws";
import { differencesFrom, formatManifest, MANIFEST, manifestOf } from "../batch/manifest";
import { readPlantNumbers } from "../batch/plant_numbers";
import {
	checkFormat,
	fileNamesOf,
	growMember,
	type MadeFile,
	memberOf,
	type Series,
	type SeriesPlant,
} from "../batch/series";
import { partOf, readShard, type Shard } from "../batch/shard";
import { columnsOf, failedRow, readLines, rowOf, type TableRow, written } from "../batch/table";
import { Unusable } from "../batch/unusable";
import { checkVaried, readVary } from "../batch/vary";
import { CoreCache } from "../core/cores";
import { crc32Digits } from "../formats/crc32";
import { makeFile } from "../generate/files/make";
import { growPlant } from "../generate/growth";
import { messageOf } from "../locale/message_error";
import type { CommandCall } from "./arguments";
import type { BatchCall } from "./batch_arguments";
import { refuseUnused } from "./file_options";
import { text } from "./messages.generated";
import { requestedSpecimen } from "./requested_specimen";
import type { CommandEnvironment } from "./surroundings";
import { TableLock } from "./table_lock";
import { readTargets } from "./targets";
import { type TimeLimit, TimeOverError } from "./time_limit";
import { MISSED, optionError, TIME_OVER } from "./usage";
import { writing } from "./writing";

/** Milliseconds between two reports of progress. */
const REPORT_INTERVAL = 5000;
/** The most differences between two series in a message. */
const NAMED = 3;

interface SeriesRequest {
	series: Series;
	/** Numbers of all plants, in order. */
	all: readonly number[];
	/** The number of parts. */
	parts: number;
	/** Numbers of the requested part, in order. */
	numbers: readonly number[];
	folder: string;
	/** The table's path. */
	table: string;
}

/**
 * Grows the part of a series that this call has to, while it holds the lock of the table.
 * @returns the exit status: 0 all plants are written, 1 some could not be grown, 3 some miss their targets, 5 the time
 * limit was reached before all were written
 */
export async function growSeries(
	call: CommandCall,
	batch: BatchCall,
	limit: TimeLimit,
	world: CommandEnvironment,
): Promise<number> {
	const request = await readSeries(call, batch, world);
	await claimFolder(request, world);
	const lock = await TableLock.acquire(request.table, world);
	const stopListening = world.whenTerminated(() => lock.release());
	try {
		return await growInto(request, lock, limit, world);
	} finally {
		stopListening();
		await lock.release();
	}
}

/**
 * Writes the manifest of the folder, or compares it with the existing one.
 * @throws UsageError where the folder holds another series, or files that this one would overwrite
 */
async function claimFolder({ series, all, parts, folder }: SeriesRequest, world: CommandEnvironment): Promise<void> {
	await writing(folder, () => world.makeFolder(folder));
	const path = join(folder, MANIFEST);
	const manifest = manifestOf(series, all, parts);
	// Read the names before the manifest: a series writes its manifest before its files.
	const names = new Set(await world.listFolder(folder).catch(() => []));
	const read = () => world.readFile(path).catch(() => undefined);
	let existing = await read();
	if (!existing) {
		const plantFile = all.flatMap((number) => fileNamesOf(series, number)).find((file) => names.has(file));
		const taken = plantFile ?? [...names].find((name) => /^plants(-\d+-of-\d+)?\.csv(\.part)?$/.test(name));
		if (taken !== undefined) {
			throw optionError(
				`--out ${folder}`,
				text.message("folder_without_manifest", { file: taken, manifest: MANIFEST }),
			);
		}
		if (await writing(path, () => world.createFile(path, formatManifest(manifest)))) return;
		existing = await read();
	}
	const differences = differencesFrom(existing ? new TextDecoder().decode(existing) : "", manifest);
	if (differences.length === 0) return;
	const more = differences.length - NAMED;
	const named = [...differences.slice(0, NAMED), ...(more > 0 ? [text("more_differences", { count: more })] : [])];
	throw optionError(`--out ${folder}`, text.message("folder_of_other_series", { differences: named.join("; ") }));
}

/**
 * Grows the plants that the table lacks, then writes the table. The row of each grown plant is added to the journal,
 * from which an interrupted call goes on. Rows of plants that could not be grown are in the table only: another call
 * tries them again.
 * @param lock renewed after each plant
 * @param limit when it is reached, the call ends with TIME_OVER, and another call goes on
 * @returns the exit status
 */
async function growInto(
	request: SeriesRequest,
	lock: TableLock,
	limit: TimeLimit,
	world: CommandEnvironment,
): Promise<number> {
	const { series, numbers, folder, table } = request;
	const rowsBefore = await readTable(request, world);
	const journal = `${table}.part`;
	const rows: string[] = [];
	const report = progressReporter(numbers.length, world);
	const grower = new Grower(series, limit, world);
	const counts: SeriesCounts = { before: 0, grown: 0, failed: 0, missed: 0 };
	// The journal starts with the rows that are already complete.
	const textsBefore = [...rowsBefore.values()].map((row) => row.text);
	await writeTo(journal, [written(columnsOf(series)), ...textsBefore].join(""), world);
	for (const number of numbers) {
		const member = await memberOf(series, number);
		const rowBefore = rowsBefore.get(number);
		if (rowBefore) {
			counts.before++;
			if (rowBefore.missed) counts.missed++;
			rows.push(rowBefore.text);
		} else {
			const plant = await grower.grow(member);
			await lock.renew();
			if (!plant) {
				reportTimeOver(rowsBefore.size + counts.grown, numbers.length, limit, world);
				return TIME_OVER;
			}
			if (plant.missed) counts.missed++;
			if (plant.files) {
				// Files come before the row: a row in the journal means that its files are complete.
				for (const { name, bytes } of plant.files) await writeTo(join(folder, name), bytes, world);
				await writing(journal, () => world.appendFile(journal, plant.row));
				counts.grown++;
			} else counts.failed++;
			// The table has rows of failed plants, too. The journal has none, so that they are tried again after an
			// interruption.
			rows.push(plant.row);
		}
		report(rows.length);
	}
	await lock.renew();
	await writeTo(table, [written(columnsOf(series)), ...rows].join(""), world);
	await world.removeFile(journal);
	return reportDone(counts, request, world);
}

/** Numbers of plants of a finished series. */
interface SeriesCounts {
	/** Those that an earlier call has grown. */
	before: number;
	grown: number;
	/** Those that could not be grown. */
	failed: number;
	/** Those, of `before` and `grown`, that miss a target. */
	missed: number;
}

/** Prints that the time limit was reached after `done` of `count` plants. */
function reportTimeOver(done: number, count: number, limit: TimeLimit, world: CommandEnvironment): void {
	const problem = text("time_series", { done, count });
	world.printError(text("error", { problem: text("at_option", { option: limit.option, problem }) }));
}

/** Prints how a series has ended, and returns the exit status. */
function reportDone(
	{ before, grown, failed, missed }: SeriesCounts,
	{ numbers, table }: SeriesRequest,
	world: CommandEnvironment,
): number {
	const count = numbers.length;
	world.printError(text("series_done", { count, grown, before, table }));
	if (failed > 0) world.printError(text("error", { problem: text("series_failed", { count: failed }) }));
	if (missed > 0) world.printError(text("series_missed", { missed, count }));
	return failed > 0 ? 1 : missed > 0 ? MISSED : 0;
}

/** Reads the options of a series, and refuses those that do not fit the model. */
async function readSeries(call: CommandCall, batch: BatchCall, world: CommandEnvironment): Promise<SeriesRequest> {
	const { model, specimen: from, notes } = await requestedSpecimen(call, world);
	for (const note of notes) world.printError(text("note", { note: note.text }));
	const goals = readTargets(model, from, call.targets);
	const all = readOption("--seeds", batch.seeds, readPlantNumbers);
	const varied =
		batch.vary === undefined ? [] : readOption("--vary", batch.vary, (written) => readVary(model, written, from));
	await checkVaried(model, varied, from).catch((error: unknown) => {
		throw error instanceof Unusable ? optionError("--vary", messageOf(error)) : error;
	});
	const shard =
		batch.shard === undefined
			? undefined
			: readOption("--shard", batch.shard, (written) => readShard(written, world.environment));
	const formats = [...new Set(batch.formats)];
	for (const each of formats) readOption("--as", each, (format) => checkFormat(model, format));
	refuseUnused(call.files, formats);
	const folder = call.out ?? ".";
	return {
		series: {
			...{ model, from, varied, goals, formats, options: call.files },
			draws: batch.literal ? literalDraws() : independentDraws(model, from),
		},
		all,
		parts: shard?.total ?? 1,
		numbers: shard ? partOf(all, shard) : all,
		folder,
		table: join(folder, tableName(shard)),
	};
}

/**
 * Returns the name of the table: `plants.csv`, or `plants-03-of-16.csv` for a part, so that sorted parts are in order.
 */
function tableName(shard: Shard | undefined): string {
	if (!shard) return "plants.csv";
	const { index, total } = shard;
	return `plants-${String(index).padStart(String(total).length, "0")}-of-${total}.csv`;
}

/** Reads the rows of the table and the journal whose files are all complete, by the plants' numbers. */
async function readTable(
	{ series, numbers, folder, table }: SeriesRequest,
	world: CommandEnvironment,
): Promise<Map<number, TableRow>> {
	const journalled = new Map<number, TableRow>();
	for (const path of [table, `${table}.part`]) {
		const bytes = await world.readFile(path).catch(() => undefined);
		if (!bytes) continue;
		const lines = readLines(series, new TextDecoder().decode(bytes));
		if (!lines) {
			throw optionError(`--out ${folder}`, text.message("other_columns", { file: path }));
		}
		for (const [number, line] of lines) journalled.set(number, line);
	}
	const rows = new Map<number, TableRow>();
	if (journalled.size === 0) return rows;
	for (const number of numbers) {
		const line = journalled.get(number);
		if (!line) continue;
		const { files, link } = await memberOf(series, number);
		const isOwn = line.link === link && line.files.every(({ name }, at) => name === files[at]);
		if (isOwn && (await areWhole(folder, line, world))) rows.set(number, line);
	}
	return rows;
}

/** Returns whether all files of a row exist with the size and the checksum that the row lists. */
async function areWhole(folder: string, { files }: TableRow, world: CommandEnvironment): Promise<boolean> {
	for (const { name, bytes, sum } of files) {
		const data = await world.readFile(join(folder, name)).catch(() => undefined);
		if (data?.length !== bytes || crc32Digits(data) !== sum) return false;
	}
	return true;
}

/** Grows one plant after the other with the same cores, and replaces cores that crashed. */
class Grower {
	readonly #series: Series;
	readonly #limit: TimeLimit;
	readonly #cores: CoreCache;

	constructor(series: Series, limit: TimeLimit, world: CommandEnvironment) {
		this.#series = series;
		this.#limit = limit;
		this.#cores = new CoreCache((wasm) => world.loadCore(wasm, limit.passed));
	}

	/**
	 * Grows one plant. A plant that cannot be grown gets a row with the reason.
	 * @returns a plant's row of the table, its files where it could be grown, and whether it misses a target; undefined
	 * where the time limit was reached before the plant was whole
	 */
	async grow(member: SeriesPlant): Promise<{ row: string; files?: readonly MadeFile[]; missed: boolean } | undefined> {
		const series = this.#series;
		const limit = this.#limit;
		const run = this.#cores.grow.bind(this.#cores);
		try {
			const grown = await growMember(series, member, {
				make: makeFile,
				grow: (model, specimen, options) =>
					limit.whole(() => growPlant(model, specimen, options, run, { timeIsOver: limit.isOver })),
			});
			return { row: written(rowOf(series, member, grown)), files: grown.files, missed: grown.missed.length > 0 };
		} catch (error) {
			if (error instanceof TimeOverError) return undefined;
			const why = error instanceof Error ? error.message : String(error);
			return { row: written(failedRow(series, member, why)), missed: false };
		}
	}
}

/** Replaces a file; a failure names its path. */
const writeTo = (path: string, data: string | Uint8Array, world: CommandEnvironment) =>
	writing(path, () => world.replaceFile(path, data));

/** Reads the text of an option, and adds the option's name to errors. */
function readOption<Value>(option: string, written: string, read: (written: string) => Value): Value {
	try {
		return read(written);
	} catch (error) {
		throw error instanceof Unusable ? optionError(`${option} ${written.slice(0, 80)}`, messageOf(error)) : error;
	}
}

/** Returns a function that prints progress, at most every `REPORT_INTERVAL`. */
function progressReporter(total: number, world: CommandEnvironment): (done: number) => void {
	let lastReport = performance.now();
	return (done) => {
		if (performance.now() - lastReport < REPORT_INTERVAL) return;
		lastReport = performance.now();
		world.printError(text("series_progress", { done, count: total }));
	};
}
