/** Parses the words of the command line into a call, without reading its values. */
import { parseArgs } from "node:util";
import {
	type FileOptions,
	fileOptionRange,
	isFileOptionValue,
	type NumericFileOptionKey,
} from "../formats/file_options";
import { MAX_TRACE_ENTRIES, type TraceRequest } from "../plant/derivation_trace";
import { BATCH_OPTIONS, type BatchCall, readBatch } from "./batch_arguments";
import { UsageError } from "./usage";

export interface CommandCall {
	help: boolean;
	/** Whether to list the models and their presets, instead of growing. */
	list: boolean;
	/** Preset or link: `long-conical`, `leaf/oak`, `leaf`, `?v=2&…`. */
	source: string | undefined;
	seed: string | undefined;
	/** By key; the last value where a key is repeated. */
	set: Record<string, string>;
	/** Unread targets: `bunch_length=160`. */
	targets: readonly string[];
	grammarFile: string | undefined;
	boundaryFile: string | undefined;
	/** Whether the JSON gets the derived string. */
	string: boolean;
	/** The part of the derivation that the JSON traces. */
	trace: TraceRequest | undefined;
	/** The form among files with the suffix of `out`. */
	form: string | undefined;
	files: FileOptions;
	/** The time limit in seconds. */
	seconds?: number;
	/** A file; for a series, a folder. */
	out: string | undefined;
	/** Undefined for a single plant. */
	batch: BatchCall | undefined;
}

/** @throws UsageError */
export function readArguments(words: readonly string[]): CommandCall {
	const { values, positionals } = parse(words);
	if (positionals.length > 1) {
		throw new UsageError(`one preset or link at a time: “${positionals[1]}” is one too many; put quotes around a link`);
	}
	const batch = readBatch(values);
	const alone = (["form", "string", "chronicle"] as const).find((key) => values[key]);
	if (batch && alone)
		throw new UsageError(`--${alone} is for a single plant; for a series, choose the kinds of files with --as`);
	// Each row of a series' table restores its plant by its link alone, and links hold no meshes.
	if (batch && values.boundary)
		throw new UsageError("--boundary is for one plant: links do not hold meshes, and a series is known by its links");
	return {
		help: values.help ?? false,
		list: values.list ?? false,
		source: positionals[0],
		seed: last(values.seed),
		set: Object.fromEntries((values.set ?? []).map(readSetting)),
		targets: values.target ?? [],
		grammarFile: last(values.grammar),
		boundaryFile: last(values.boundary),
		string: values.string ?? false,
		trace: values.chronicle === undefined ? undefined : readTrace(values.chronicle.at(-1) ?? ""),
		...(values.seconds ? numberOf("seconds", last(values.seconds), 0.1, 1_000_000) : {}),
		out: last(values.out),
		form: last(values.form),
		files: {
			...fileOption("triangles", last(values.triangles)),
			...fileOption("thickness", last(values.thickness)),
			...fileOption("points", last(values.points)),
			...(values.translucent ? { translucent: true } : {}),
			...(values.textures ? { textures: true } : {}),
		},
		batch,
	};
}

const OPTIONS = {
	help: { type: "boolean", short: "h" },
	list: { type: "boolean" },
	seed: { type: "string", multiple: true },
	set: { type: "string", multiple: true },
	target: { type: "string", multiple: true },
	grammar: { type: "string", multiple: true },
	boundary: { type: "string", multiple: true },
	string: { type: "boolean" },
	chronicle: { type: "string", multiple: true },
	seconds: { type: "string", multiple: true },
	out: { type: "string", short: "o", multiple: true },
	form: { type: "string", multiple: true },
	triangles: { type: "string", multiple: true },
	thickness: { type: "string", multiple: true },
	points: { type: "string", multiple: true },
	translucent: { type: "boolean" },
	textures: { type: "boolean" },
	...BATCH_OPTIONS,
} as const;

function parse(words: readonly string[]) {
	try {
		return parseArgs({ args: [...words], options: OPTIONS, allowPositionals: true });
	} catch (error) {
		const { message } = error as Error;
		const [, option] = /^Option '(\S+)' argument is ambiguous/.exec(message) ?? [];
		if (option) {
			throw new UsageError(`${option} needs a value; one that begins with a dash is joined with =, as in --seed=-1`);
		}
		// Node's own words, without the advice after the first sentence.
		const [sentence] = message.split(/\.\s|\n/);
		throw new UsageError(`${sentence.replaceAll("'", "").replace(/\.$/, "")}; see --help`);
	}
}

function readSetting(setting: string): [string, string] {
	const at = setting.indexOf("=");
	if (at < 1) throw new UsageError(`--set ${setting}: write KEY=VALUE, as in --set age=50`);
	return [setting.slice(0, at).trim(), setting.slice(at + 1).trim()];
}

/** @throws UsageError where it is no step with an optional window */
function readTrace(text: string): TraceRequest {
	const [step, first, count] = text.split(",").map((word) => (/^\s*\d+\s*$/.test(word) ? Number(word) : Number.NaN));
	const fits = [step, first ?? 0].every((value) => value <= 0xffffffff) && (count ?? 0) <= MAX_TRACE_ENTRIES;
	if (!fits || text.split(",").length > 3)
		throw new UsageError(
			`--chronicle ${text}: a step, 0 or more; then where you like the first module and how many, at most ${MAX_TRACE_ENTRIES}: 3,100,50`,
		);
	return { step, ...(first === undefined ? {} : { first }), ...(count === undefined ? {} : { count }) };
}

/** @throws UsageError where it is no number from `least` to `most` */
function numberOf<Key extends string>(key: Key, text: string | undefined, least: number, most: number) {
	if (text === undefined) return {};
	const value = text.trim() === "" ? Number.NaN : Number(text);
	if (!(value >= least && value <= most)) throw new UsageError(`--${key} ${text}: a number from ${least} to ${most}`);
	return { [key]: value } as { [key in Key]: number };
}

/** @throws UsageError where the option does not accept it */
function fileOption(key: NumericFileOptionKey, text: string | undefined): FileOptions {
	if (text === undefined) return {};
	const value = text.trim() === "" ? Number.NaN : Number(text);
	if (!isFileOptionValue(key, value)) throw new UsageError(`--${key} ${text}: ${fileOptionRange(key)}`);
	return { [key]: value };
}

function last<Value>(values: readonly Value[] | undefined): Value | undefined {
	return values?.at(-1);
}
