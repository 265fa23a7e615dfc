/**
 * Grows a series into a folder: a file for each plant, a table of them and a manifest. What is there and whole is not grown again: the table
 * has its name once all of it is there, until then its lines are in a journal beside it. A folder holds one series, and one process writes a table.
 */
import { join } from "node:path";
import { crc32 } from "../batch/crc32";
import { independentDraws, literalDraws } from "../batch/draws";
import { differencesFrom, MANIFEST, manifestOf, writtenManifest } from "../batch/manifest";
import { readPlantNumbers } from "../batch/plant_numbers";
import { checkFormat, fileOf, growMember, type Member, memberOf, type Series } from "../batch/series";
import { partOf, readShard, type Shard } from "../batch/shard";
import { columnsOf, failedRow, type Line, readLines, rowOf, written } from "../batch/table";
import { Unusable } from "../batch/unusable";
import { checkVaried, readVary } from "../batch/vary";
import { Cores } from "../core/cores";
import { growPlant } from "../files/growth";
import { makeFile } from "../files/make";
import type { Call } from "./arguments";
import { askedSpecimen } from "./asked_specimen";
import type { BatchCall } from "./batch_arguments";
import type { Surroundings } from "./surroundings";
import { TableLock } from "./table_lock";
import { readTargets } from "./targets";
import { UsageError } from "./usage";
import { writing } from "./writing";

/** How often it says how far it is, in milliseconds. */
const PATIENCE = 5000;
/** Differences between two series that a message names. */
const NAMED = 3;

interface Asked {
	series: Series;
	/** Of all plants, in order. */
	all: readonly number[];
	/** In how many parts they are grown. */
	parts: number;
	/** Of the part that is wanted, in order. */
	numbers: readonly number[];
	folder: string;
	/** The table's path. */
	table: string;
}

/** @returns the exit status: 0 all are there, 1 some could not be grown */
export async function growSeries(call: Call, batch: BatchCall, world: Surroundings): Promise<number> {
	const asked = await readSeries(call, batch, world);
	await claimFolder(asked, world);
	const lock = await TableLock.take(asked.table, world);
	const forget = world.whenTerminated(() => lock.release());
	try {
		return await growInto(asked, lock, world);
	} finally {
		forget();
		await lock.release();
	}
}

/**
 * Leaves the folder's manifest, or compares it with the one that is there.
 * @throws UsageError where the folder holds another series, or files that this one would overwrite
 */
async function claimFolder({ series, all, parts, folder }: Asked, world: Surroundings): Promise<void> {
	await writing(folder, () => world.makeFolder(folder));
	const path = join(folder, MANIFEST);
	const manifest = manifestOf(series, all, parts);
	// Names first: files are there only after their manifest.
	const names = new Set(await world.listFolder(folder).catch(() => []));
	const read = () => world.readFile(path).catch(() => undefined);
	let there = await read();
	if (!there) {
		const own = all.map((number) => fileOf(series, number)).find((file) => names.has(file));
		const taken = own ?? [...names].find((name) => /^plants(-\d+-of-\d+)?\.csv(\.part)?$/.test(name));
		if (taken !== undefined) {
			throw new UsageError(
				`--out ${folder}: ${taken} is there, and no ${MANIFEST} says of which series; choose another folder`,
			);
		}
		if (await writing(path, () => world.createFile(path, writtenManifest(manifest)))) return;
		there = await read();
	}
	const differences = differencesFrom(there ? new TextDecoder().decode(there) : "", manifest);
	if (differences.length === 0) return;
	const more = differences.length > NAMED ? ` and ${differences.length - NAMED} more` : "";
	throw new UsageError(
		`--out ${folder} holds another series (${differences.slice(0, NAMED).join("; ")}${more}); choose another folder`,
	);
}

async function growInto(asked: Asked, lock: TableLock, world: Surroundings): Promise<number> {
	const { series, numbers, folder, table } = asked;
	const kept = await readTable(asked, world);
	const journal = `${table}.part`;
	const lines: string[] = [];
	const say = sayer(numbers.length, world);
	const grower = new Grower(series, world);
	let [there, failed] = [0, 0];
	await writeTo(journal, [written(columnsOf(series)), ...kept.values()].join(""), world);
	for (const number of numbers) {
		const member = await memberOf(series, number);
		let line = kept.get(member.file);
		if (line !== undefined) there++;
		else {
			const made = await grower.grow(member);
			await lock.keep();
			line = made.line;
			if (!made.file) failed++;
			else {
				await writeTo(join(folder, member.file), made.file, world);
				await writing(journal, () => world.appendFile(journal, made.line));
			}
		}
		lines.push(line);
		say(lines.length);
	}
	await lock.keep();
	await writeTo(table, [written(columnsOf(series)), ...lines].join(""), world);
	await world.removeFile(journal);
	world.say(`${numbers.length} plants: ${numbers.length - there - failed} grown, ${there} there before; ${table}`);
	if (failed > 0) world.say(`grow: ${failed} could not be grown; their lines have no file and say why`);
	return failed > 0 ? 1 : 0;
}

async function readSeries(call: Call, batch: BatchCall, world: Surroundings): Promise<Asked> {
	const { model, specimen: from, notes } = await askedSpecimen(call, world);
	for (const note of notes) world.say(`note: ${note.text}`);
	const aims = readTargets(model, from, call.targets);
	const all = typed("--seeds", batch.seeds, readPlantNumbers);
	const varied = batch.vary === undefined ? [] : typed("--vary", batch.vary, (text) => readVary(model, text, from));
	await checkVaried(model, varied, from).catch((error: unknown) => {
		throw error instanceof Unusable ? new UsageError(`--vary ${error.message}`) : error;
	});
	const shard =
		batch.shard === undefined ? undefined : typed("--shard", batch.shard, (text) => readShard(text, world.environment));
	typed("--as", batch.format, (format) => checkFormat(model, format));
	const folder = call.out ?? ".";
	return {
		series: {
			...{ model, from, varied, aims, format: batch.format },
			draws: batch.literal ? literalDraws() : independentDraws(model, from),
		},
		all,
		parts: shard?.total ?? 1,
		numbers: shard ? partOf(all, shard) : all,
		folder,
		table: join(folder, tableName(shard)),
	};
}

/** `plants.csv`, or of a part `plants-03-of-16.csv`: sorted by name, parts are in order. */
function tableName(shard: Shard | undefined): string {
	if (!shard) return "plants.csv";
	const { index, total } = shard;
	return `plants-${String(index).padStart(String(total).length, "0")}-of-${total}.csv`;
}

/** The lines whose files are there and whole, by the files' names. */
async function readTable({ series, numbers, folder, table }: Asked, world: Surroundings): Promise<Map<string, string>> {
	const known = new Map<string, Line>();
	for (const path of [table, `${table}.part`]) {
		const bytes = await world.readFile(path).catch(() => undefined);
		if (!bytes) continue;
		const lines = readLines(series, new TextDecoder().decode(bytes));
		if (!lines) {
			throw new UsageError(`--out ${folder}: ${path} has other columns than this series; choose another folder`);
		}
		for (const [file, line] of lines) known.set(file, line);
	}
	const kept = new Map<string, string>();
	if (known.size === 0) return kept;
	for (const number of numbers) {
		const { file, link } = await memberOf(series, number);
		const line = known.get(file);
		if (line?.link === link && (await isWhole(join(folder, file), line, world))) kept.set(file, line.text);
	}
	return kept;
}

async function isWhole(path: string, { bytes, sum }: Line, world: Surroundings): Promise<boolean> {
	const data = await world.readFile(path).catch(() => undefined);
	return data !== undefined && data.length === bytes && crc32(data) === sum;
}

/** Grows one plant after the other with the same cores, and with others after one that broke. */
class Grower {
	readonly #series: Series;
	readonly #cores: Cores;

	constructor(series: Series, world: Surroundings) {
		this.#series = series;
		this.#cores = new Cores((wasm) => world.loadCore(wasm));
	}

	/** @returns a plant's line of the table, and its file where it could be grown */
	async grow(member: Member): Promise<{ line: string; file?: Uint8Array }> {
		const series = this.#series;
		const run = this.#cores.grow.bind(this.#cores);
		try {
			const grown = await growMember(series, member, {
				make: makeFile,
				grow: (model, specimen, options) => growPlant(model, specimen, options, run),
			});
			return { line: written(rowOf(series, member, grown)), file: grown.bytes };
		} catch (error) {
			const why = error instanceof Error ? error.message : String(error);
			return { line: written(failedRow(series, member, why)) };
		}
	}
}

const writeTo = (path: string, data: string | Uint8Array, world: Surroundings) =>
	writing(path, () => world.replaceFile(path, data));

/** What cannot be used says where it was written. */
function typed<Value>(option: string, text: string, read: (text: string) => Value): Value {
	try {
		return read(text);
	} catch (error) {
		throw error instanceof Unusable ? new UsageError(`${option} ${text.slice(0, 80)}: ${error.message}`) : error;
	}
}

/** Says now and then how far it is. */
function sayer(total: number, world: Surroundings): (done: number) => void {
	let last = performance.now();
	return (done) => {
		if (performance.now() - last < PATIENCE) return;
		last = performance.now();
		world.say(`${done} of ${total} plants`);
	};
}
