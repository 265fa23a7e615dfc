/** Help and errors of the command. */

import { formatKeysOf } from "../batch/series";
import { FORMS, LOW_TRIANGLES, POINTS, THICKNESS } from "../formats/plant_files";
import { MessageError } from "../locale/message_error";
import type { Message } from "../locale/texts";
import { DEFAULT_MODEL } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { text } from "./messages.generated";
import { endingsOf } from "./outputs";

/** An error in the call of the command: one line, and exit status 2. */
export class UsageError extends MessageError {
	override name = "UsageError";

	/** @param below lines below the message: a text's line with a mark at the position */
	constructor(
		message: Message,
		readonly below = "",
	) {
		super(message);
	}
}

/** Returns the error of an option: "--set age: “x” is not a number." `code` and `args` are those of the problem. */
export const optionError = (option: string, { code, args, text: problem }: Message): UsageError =>
	new UsageError({ code, args, text: text("at_option", { option, problem }) });

/** Exit status where everything is grown and a target is missed. */
export const MISSED = 3;

/** Exit status where the time limit, `--seconds`, was reached. */
export const TIME_OVER = 5;

/** Exit status where a limit of the core cut the plant short. */
export const CUT_SHORT = 6;

/** Returns the text of --help for one model, with the names of the others. */
export function usage(model: Model, models: readonly string[]): string {
	const { name, title, table, presets, details, formats, targets } = model;
	const keys = [...table.links].map(([key, entries]) => {
		const [entry, ...others] = entries;
		if (others.length > 0) return `${key}=${entries.map((_, index) => String.fromCharCode(65 + index)).join()}`;
		return entry.kind === "choice" ? `${key}=${entry.options.join("|")}` : key;
	});
	const reachable = targets?.measures(fromPreset(model)) ?? [];
	const prefix = name === DEFAULT_MODEL ? "" : `${name}/`;
	const others = models.filter((each) => each !== name).map((each) => `${each} --help`);
	const standard = `${prefix}${presets.standard}`;
	return text("usage", {
		title: title.toLowerCase(),
		model: name,
		preset: presets.standard,
		presets: wrapped(presets.list.map((preset) => prefix + preset.name)),
		standard: prefix === "" ? text("usage_default_prefix", { standard, model: name }) : standard,
		keys: wrapped([...keys, ...details.flatMap(({ settings = [] }) => settings)]),
		targets: reachable.length > 0 ? text("usage_targets", { measures: wrapped(reachable) }) : "",
		endings: endingsOf({ formats }),
		forms: FORMS.join(", "),
		form: FORMS[0],
		triangles: String(LOW_TRIANGLES),
		thickness: String(THICKNESS),
		points: String(POINTS),
		kinds: wrapped(formatKeysOf({ formats })),
		help:
			others.length > 0
				? wrapped(text("usage_other_models", { models: others.join(", ") }).split(" "))
				: text("usage_this"),
	});
}

const WIDTH = 80;
const INDENT = 19;

/** Joins words into lines of at most `WIDTH` characters; lines after the first are indented. */
function wrapped(words: readonly string[]): string {
	const lines = [""];
	for (const word of words) {
		const line = lines[lines.length - 1];
		if (line.length + 1 + word.length > WIDTH) lines.push(word);
		else lines[lines.length - 1] = line ? `${line} ${word}` : word;
	}
	return lines.join(`\n${" ".repeat(INDENT)}`);
}
