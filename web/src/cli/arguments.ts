/** Parses the words of the command line into a call, without reading its values. */
import { parseArgs } from "node:util";
import {
	type FileOptions,
	fileOptionProblem,
	isFileOptionValue,
	type NumericFileOptionKey,
} from "../formats/file_options";
import { MAX_TRACE_ENTRIES, type TraceRequest } from "../plant/derivation_trace";
import { BATCH_OPTIONS, type BatchCall, readBatch } from "./batch_arguments";
import { text } from "./messages.generated";
import { optionError, UsageError } from "./usage";

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

/**
 * Parses the command line, and refuses options that exclude each other.
 * @throws UsageError
 */
export function readArguments(words: readonly string[]): CommandCall {
	const { values, positionals } = parse(words);
	if (positionals.length > 1) {
		throw new UsageError(text.message("one_source", { extra: positionals[1] }));
	}
	const batch = readBatch(values);
	const alone = (["form", "string", "chronicle"] as const).find((key) => values[key]);
	if (batch && alone) throw optionError(`--${alone}`, text.message("only_single_plant"));
	// Each row of a series' table restores its plant by its link alone, and links hold no meshes.
	if (batch && values.boundary) throw optionError("--boundary", text.message("boundary_single_plant"));
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
			...(values["wind-colours"] ? { windColours: true } : {}),
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
	"wind-colours": { type: "boolean" },
	...BATCH_OPTIONS,
} as const;

/** Parses options by Node's `parseArgs`, whose errors become UsageErrors. */
function parse(words: readonly string[]) {
	try {
		return parseArgs({ args: [...words], options: OPTIONS, allowPositionals: true });
	} catch (error) {
		const { message } = error as Error;
		const [, option] = /^Option '(\S+)' argument is ambiguous/.exec(message) ?? [];
		if (option) {
			throw new UsageError(text.message("option_needs_value", { option }));
		}
		// Node's own words, without the advice after the first sentence.
		const [sentence] = message.split(/\.\s|\n/);
		throw new UsageError(
			text.message("option_unreadable", { problem: sentence.replaceAll("'", "").replace(/\.$/, "") }),
		);
	}
}

/**
 * Splits `key=value` of `--set`.
 * @throws UsageError without a key
 */
function readSetting(setting: string): [string, string] {
	const separator = setting.indexOf("=");
	if (separator < 1) throw optionError(`--set ${setting}`, text.message("write_setting"));
	return [setting.slice(0, separator).trim(), setting.slice(separator + 1).trim()];
}

/**
 * Reads `STEP[,FIRST[,COUNT]]` of `--chronicle`: a step of the derivation, and a range of its modules.
 * @throws UsageError where it is anything else
 */
function readTrace(written: string): TraceRequest {
	const [step, first, count] = written.split(",").map((word) => (/^\s*\d+\s*$/.test(word) ? Number(word) : Number.NaN));
	const fits = [step, first ?? 0].every((value) => value <= 0xffffffff) && (count ?? 0) <= MAX_TRACE_ENTRIES;
	if (!fits || written.split(",").length > 3)
		throw optionError(`--chronicle ${written}`, text.message("write_trace", { most: MAX_TRACE_ENTRIES }));
	return { step, ...(first === undefined ? {} : { first }), ...(count === undefined ? {} : { count }) };
}

/**
 * Reads the number of an option, as an object with its key; empty without the option.
 * @throws UsageError where it is no number from `least` to `most`
 */
function numberOf<Key extends string>(key: Key, written: string | undefined, least: number, most: number) {
	if (written === undefined) return {};
	const value = written.trim() === "" ? Number.NaN : Number(written);
	if (!(value >= least && value <= most))
		throw optionError(`--${key} ${written}`, text.message("number_out_of_range", { least, most }));
	return { [key]: value } as { [key in Key]: number };
}

/**
 * Reads the number of an option of files, as an object with its key; empty without the option.
 * @throws UsageError where the option does not accept it
 */
function fileOption(key: NumericFileOptionKey, written: string | undefined): FileOptions {
	if (written === undefined) return {};
	const value = written.trim() === "" ? Number.NaN : Number(written);
	if (!isFileOptionValue(key, value)) throw new UsageError(fileOptionProblem(key, `--${key}`));
	return { [key]: value };
}

/** Returns the last value of a repeated option; undefined without the option. */
function last<Value>(values: readonly Value[] | undefined): Value | undefined {
	return values?.at(-1);
}
