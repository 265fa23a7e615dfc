/**
 * Grows a series into a folder: a file for each plant, a table of them and a manifest. Complete plants are not grown
 * again: rows are in a journal beside the table, which is renamed to the table once it is complete. A folder holds one
 * series, and one process writes a table.
 */
import { join } from "node:path";
import { crc32 } from "../batch/crc32";
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
import { makeFile } from "../generate/files/make";
import { growPlant } from "../generate/growth";
import type { CommandCall } from "./arguments";
import type { BatchCall } from "./batch_arguments";
import { refuseUnused } from "./file_options";
import { requestedSpecimen } from "./requested_specimen";
import type { CommandEnvironment } from "./surroundings";
import { TableLock } from "./table_lock";
import { readTargets } from "./targets";
import { type TimeLimit, TimeOverError } from "./time_limit";
import { MISSED, TIME_OVER, UsageError } from "./usage";
import { writing } from "./writing";

/** Milliseconds between two reports of progress. */
const REPORT_INTERVAL = 5000;
/** The advice where the time limit ends a series. */
const CONTINUE = "the same call continues the series; where no plant is added, give it more seconds";
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
	let there = await read();
	if (!there) {
		const own = all.flatMap((number) => fileNamesOf(series, number)).find((file) => names.has(file));
		const taken = own ?? [...names].find((name) => /^plants(-\d+-of-\d+)?\.csv(\.part)?$/.test(name));
		if (taken !== undefined) {
			throw new UsageError(
				`--out ${folder}: ${taken} exists, but no ${MANIFEST} that describes its series; choose another folder`,
			);
		}
		if (await writing(path, () => world.createFile(path, formatManifest(manifest)))) return;
		there = await read();
	}
	const differences = differencesFrom(there ? new TextDecoder().decode(there) : "", manifest);
	if (differences.length === 0) return;
	const more = differences.length > NAMED ? ` and ${differences.length - NAMED} more` : "";
	throw new UsageError(
		`--out ${folder} holds another series (${differences.slice(0, NAMED).join("; ")}${more}); choose another folder`,
	);
}

async function growInto(
	request: SeriesRequest,
	lock: TableLock,
	limit: TimeLimit,
	world: CommandEnvironment,
): Promise<number> {
	const { series, numbers, folder, table } = request;
	const rows = await readTable(request, world);
	const journal = `${table}.part`;
	const lines: string[] = [];
	const report = progressReporter(numbers.length, world);
	const grower = new Grower(series, limit, world);
	let [there, grown, failed, missed] = [0, 0, 0, 0];
	const before = [...rows.values()].map(({ text }) => text);
	await writeTo(journal, [written(columnsOf(series)), ...before].join(""), world);
	for (const number of numbers) {
		const member = await memberOf(series, number);
		const known = rows.get(number);
		if (known?.missed) missed++;
		let line = known?.text;
		if (line !== undefined) there++;
		else {
			const made = await grower.grow(member);
			await lock.renew();
			if (!made) {
				world.printError(
					`grow: ${limit.option}: the time limit was reached: ${rows.size + grown} of ${numbers.length} plants are written; ${CONTINUE}`,
				);
				return TIME_OVER;
			}
			line = made.line;
			if (made.missed) missed++;
			if (!made.files) failed++;
			else {
				for (const { name, bytes } of made.files) await writeTo(join(folder, name), bytes, world);
				await writing(journal, () => world.appendFile(journal, made.line));
				grown++;
			}
		}
		lines.push(line);
		report(lines.length);
	}
	await lock.renew();
	await writeTo(table, [written(columnsOf(series)), ...lines].join(""), world);
	await world.removeFile(journal);
	world.printError(
		`${numbers.length} plants: ${numbers.length - there - failed} grown, ${there} there before; ${table}`,
	);
	if (failed > 0)
		world.printError(`grow: ${failed} could not be grown; the column “notes” of the table has the reasons`);
	if (missed > 0)
		world.printError(
			`target: ${missed} of ${numbers.length} plants miss a target; the column “missed” of the table has the measures`,
		);
	return failed > 0 ? 1 : missed > 0 ? MISSED : 0;
}

async function readSeries(call: CommandCall, batch: BatchCall, world: CommandEnvironment): Promise<SeriesRequest> {
	const { model, specimen: from, notes } = await requestedSpecimen(call, world);
	for (const note of notes) world.printError(`note: ${note.text}`);
	const goals = readTargets(model, from, call.targets);
	const all = typed("--seeds", batch.seeds, readPlantNumbers);
	const varied = batch.vary === undefined ? [] : typed("--vary", batch.vary, (text) => readVary(model, text, from));
	await checkVaried(model, varied, from).catch((error: unknown) => {
		throw error instanceof Unusable ? new UsageError(`--vary ${error.message}`) : error;
	});
	const shard =
		batch.shard === undefined ? undefined : typed("--shard", batch.shard, (text) => readShard(text, world.environment));
	const formats = [...new Set(batch.formats)];
	for (const each of formats) typed("--as", each, (format) => checkFormat(model, format));
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

/** `plants.csv`, or `plants-03-of-16.csv` for a part: sorted by name, parts are in order. */
function tableName(shard: Shard | undefined): string {
	if (!shard) return "plants.csv";
	const { index, total } = shard;
	return `plants-${String(index).padStart(String(total).length, "0")}-of-${total}.csv`;
}

/** The rows whose files are all there and complete, by the plants' numbers. */
async function readTable(
	{ series, numbers, folder, table }: SeriesRequest,
	world: CommandEnvironment,
): Promise<Map<number, TableRow>> {
	const known = new Map<number, TableRow>();
	for (const path of [table, `${table}.part`]) {
		const bytes = await world.readFile(path).catch(() => undefined);
		if (!bytes) continue;
		const lines = readLines(series, new TextDecoder().decode(bytes));
		if (!lines) {
			throw new UsageError(`--out ${folder}: ${path} has other columns than this series; choose another folder`);
		}
		for (const [number, line] of lines) known.set(number, line);
	}
	const rows = new Map<number, TableRow>();
	if (known.size === 0) return rows;
	for (const number of numbers) {
		const line = known.get(number);
		if (!line) continue;
		const { files, link } = await memberOf(series, number);
		const isOwn = line.link === link && line.files.every(({ name }, at) => name === files[at]);
		if (isOwn && (await areWhole(folder, line, world))) rows.set(number, line);
	}
	return rows;
}

async function areWhole(folder: string, { files }: TableRow, world: CommandEnvironment): Promise<boolean> {
	for (const { name, bytes, sum } of files) {
		const data = await world.readFile(join(folder, name)).catch(() => undefined);
		if (data?.length !== bytes || crc32(data) !== sum) return false;
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
	 * @returns a plant's row of the table, its files where it could be grown, and whether it misses a target; undefined
	 * where the time limit was reached before the plant was whole
	 */
	async grow(member: SeriesPlant): Promise<{ line: string; files?: readonly MadeFile[]; missed: boolean } | undefined> {
		const series = this.#series;
		const limit = this.#limit;
		const run = this.#cores.grow.bind(this.#cores);
		try {
			const grown = await growMember(series, member, {
				make: makeFile,
				grow: (model, specimen, options) =>
					limit.whole(() => growPlant(model, specimen, options, run, { timeIsOver: limit.isOver })),
			});
			return { line: written(rowOf(series, member, grown)), files: grown.files, missed: grown.missed.length > 0 };
		} catch (error) {
			if (error instanceof TimeOverError) return undefined;
			const why = error instanceof Error ? error.message : String(error);
			return { line: written(failedRow(series, member, why)), missed: false };
		}
	}
}

const writeTo = (path: string, data: string | Uint8Array, world: CommandEnvironment) =>
	writing(path, () => world.replaceFile(path, data));

/** Adds the name of the option to errors about its text. */
function typed<Value>(option: string, text: string, read: (text: string) => Value): Value {
	try {
		return read(text);
	} catch (error) {
		throw error instanceof Unusable ? new UsageError(`${option} ${text.slice(0, 80)}: ${error.message}`) : error;
	}
}

/** A function that reports progress from time to time. */
function progressReporter(total: number, world: CommandEnvironment): (done: number) => void {
	let last = performance.now();
	return (done) => {
		if (performance.now() - last < REPORT_INTERVAL) return;
		last = performance.now();
		world.printError(`${done} of ${total} plants`);
	};
}
