/**
 * Grows a series into a folder: a file for each plant and a table of them. What is there and whole is not grown again: the table
 * bears its name once all of it is there, until then its lines are in a journal beside it.
 */
import { join } from "node:path";
import { crc32 } from "../batch/crc32";
import { independentDraws, literalDraws } from "../batch/draws";
import { readPlantNumbers } from "../batch/plant_numbers";
import { checkFormat, growMember, type Member, memberOf, type Series } from "../batch/series";
import { partOf, readShard, type Shard } from "../batch/shard";
import { columnsOf, failedRow, type Line, readLines, rowOf, written } from "../batch/table";
import { Unusable } from "../batch/unusable";
import { checkVaried, readVary } from "../batch/vary";
import { Cores } from "../core/cores";
import { growPlant } from "../files/growth";
import { makeFile } from "../files/make";
import type { Call } from "./arguments";
import { askedSpecimen, reasonOf } from "./asked_specimen";
import type { BatchCall } from "./batch_arguments";
import type { Surroundings } from "./surroundings";
import { readTargets } from "./targets";
import { UsageError } from "./usage";

/** How often it says how far it is, in milliseconds. */
const PATIENCE = 5000;

interface Asked {
	series: Series;
	/** Of the part that is asked for, in order. */
	numbers: readonly number[];
	folder: string;
	/** The table's path. */
	table: string;
}

/** @returns the exit status: 0 all are there, 1 some could not be grown */
export async function growSeries(call: Call, batch: BatchCall, world: Surroundings): Promise<number> {
	const asked = await readSeries(call, batch, world);
	const { series, numbers, folder, table } = asked;
	await writing(folder, () => world.makeFolder(folder));
	const kept = await readTable(asked, world);
	const journal = `${table}.part`;
	const lines: string[] = [];
	const say = sayer(numbers.length, world);
	const grower = new Grower(series, world);
	let [there, failed] = [0, 0];
	await writing(journal, () => world.replaceFile(journal, [written(columnsOf(series)), ...kept.values()].join("")));
	for (const number of numbers) {
		const member = await memberOf(series, number);
		let line = kept.get(member.file);
		if (line !== undefined) there++;
		else {
			const made = await grower.grow(member, folder);
			line = made.line;
			if (made.failed) failed++;
			else await writing(journal, () => world.appendFile(journal, made.line));
		}
		lines.push(line);
		say(lines.length);
	}
	await writing(table, () => world.replaceFile(table, [written(columnsOf(series)), ...lines].join("")));
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
			throw new UsageError(
				`--out ${folder}: ${path} is of another series; choose another folder, or take the table away`,
			);
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
	readonly #world: Surroundings;
	readonly #cores: Cores;

	constructor(series: Series, world: Surroundings) {
		this.#series = series;
		this.#world = world;
		this.#cores = new Cores((wasm) => world.loadCore(wasm));
	}

	/** Writes a plant's file. @returns its line of the table */
	async grow(member: Member, folder: string): Promise<{ line: string; failed: boolean }> {
		const series = this.#series;
		const run = this.#cores.grow.bind(this.#cores);
		try {
			const grown = await growMember(series, member, {
				make: makeFile,
				grow: (model, specimen, options) => growPlant(model, specimen, options, run),
			});
			const path = join(folder, member.file);
			await writing(path, () => this.#world.replaceFile(path, grown.bytes));
			return { line: written(rowOf(series, member, grown)), failed: false };
		} catch (error) {
			if (error instanceof UsageError) throw error;
			const why = error instanceof Error ? error.message : String(error);
			return { line: written(failedRow(series, member, why)), failed: true };
		}
	}
}

/** What cannot be used says where it was written. */
function typed<Value>(option: string, text: string, read: (text: string) => Value): Value {
	try {
		return read(text);
	} catch (error) {
		throw error instanceof Unusable ? new UsageError(`${option} ${text.slice(0, 80)}: ${error.message}`) : error;
	}
}

async function writing(path: string, write: () => Promise<void>): Promise<void> {
	await write().catch((error: unknown) => {
		throw new UsageError(`--out ${path}: ${reasonOf(error)}`);
	});
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
