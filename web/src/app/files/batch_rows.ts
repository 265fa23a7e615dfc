/**
 * Rows of the batch dialog: the settings that vary and their values, typed in the units that the panel shows. Rows are
 * written in the syntax of `--vary`, in the units of the table.
 */
import { LARGEST_CONSTANT } from "../../specimen/constants";
import {
	type DisplayScale,
	displayedNumber,
	displayedText,
	displayScaleOf,
	parseDisplayed,
} from "../../specimen/lengths";
import { type ChoiceEntry, type ColourEntry, type NumberEntry, nearestWithin, valueIn } from "../../specimen/table";
import { optionInWords } from "../../specimen/translated_tables";
import { readTyped } from "../../ui/typed";
import { text } from "../messages.generated";
import type { StudioState } from "../studio_state";

/** How a number varies: a random value between two, a random one of a list, or one value for all plants. */
export type Variation = "range" | "list" | "fixed";
export const VARIATIONS: readonly Variation[] = ["range", "list", "fixed"];

export interface BatchRow {
	/** Key of the setting: a parameter's key, or the name of a constant of the grammar. */
	readonly key: string;
	/** Always a list for choices and colours. */
	readonly variation: Variation;
	/**
	 * The values as typed: two numbers of a range, one fixed number, or the text of a list of numbers. Of a choice, its
	 * options; of a colour, six hexadecimal digits each.
	 */
	readonly values: readonly string[];
}

/** A setting that can vary. */
export type BatchSetting = { readonly key: string; readonly label: string } & (
	| { readonly kind: "choice"; readonly entry: ChoiceEntry }
	| { readonly kind: "colour"; readonly entry: ColourEntry }
	/** `entry` is undefined for a constant of the grammar, which has no limits. */
	| { readonly kind: "number"; readonly entry: NumberEntry | undefined; readonly scale: DisplayScale }
);

export interface SettingGroup {
	readonly title: string;
	readonly settings: readonly BatchSetting[];
}

type Plant = Pick<StudioState, "model" | "specimen">;

/**
 * Returns the settings that can vary: the parameters that apply to a plant, in the groups of the panel, and the
 * constants of its grammar.
 * @param constants the names that the grammar defines
 */
export function settingGroups({ model, specimen }: Plant, constants: readonly string[]): readonly SettingGroup[] {
	const { table } = model;
	const active = table.entries.filter((entry) => table.isActive(specimen, entry));
	const groups = table.groups.map(({ key, title }) => ({
		title,
		settings: active
			.filter(({ group }) => group === key)
			.map((entry): BatchSetting => {
				const named = { key: entry.key, label: entry.label };
				if (entry.kind === "choice") return { ...named, kind: entry.kind, entry };
				if (entry.kind === "colour") return { ...named, kind: entry.kind, entry };
				return { ...named, kind: "number", entry, scale: displayScaleOf(model, specimen, entry) };
			}),
	}));
	// A parameter governs the constant that it replaces.
	const governed = table.core.flatMap(({ define = [] }) => define);
	const own = constants
		.filter((name) => !governed.includes(name) && !table.entry(name))
		.map((name): BatchSetting => ({ key: name, label: name, kind: "number", entry: undefined, scale: PLAIN }));
	return [...groups, { title: text("batch_constants"), settings: own }].filter(({ settings }) => settings.length > 0);
}

/** Returns the names that the plant's grammar defines; none without a grammar. */
export async function constantsOf({ model, specimen }: Plant): Promise<readonly string[]> {
	return (await model.details.find(({ names }) => names)?.names?.(specimen)) ?? [];
}

const PLAIN: DisplayScale = { per: 1, unit: "", decimals: 2 };

/** Share of a number's whole range by which a new row extends below and above the plant's value. */
const REACH = 0.1;

/** Returns a row for a setting: a range around the plant's value, all options, or the plant's colour. */
export function rowFor({ specimen }: Pick<Plant, "specimen">, setting: BatchSetting): BatchRow {
	const { key } = setting;
	if (setting.kind === "choice") return { key, variation: "list", values: setting.entry.options };
	if (setting.kind === "colour") return { key, variation: "list", values: [String(valueIn(specimen, setting.entry))] };
	const { entry, scale } = setting;
	if (!entry) return { key, variation: "range", values: ["", ""] };
	const value = Number(valueIn(specimen, entry));
	const reach = REACH * (entry.max - entry.min);
	const near = (number: number) =>
		displayedText(entry, scale, nearestWithin(entry, Math.round(number / entry.step) * entry.step));
	return { key, variation: "range", values: [near(value - reach), near(value + reach)] };
}

/** Returns a number's row with another variation; it keeps the first value. */
export function withVariation({ key, values }: BatchRow, variation: Variation): BatchRow {
	const [first = ""] = values;
	const one = first.split(SEPARATOR)[0];
	const next = { range: [one, values[1] ?? one], list: [values.filter(Boolean).join("; ")], fixed: [one] };
	return { key, variation, values: next[variation] };
}

/**
 * Returns the name of a choice's option, as the panel shows it.
 * @param at index of the option
 */
export const optionLabel = ({ labels, options }: ChoiceEntry, at: number): string =>
	labels?.[at] ?? optionInWords(options[at]);

/** Between the numbers of a list: a comma may be a decimal comma. */
const SEPARATOR = /[;\s]+/;

/** A number that was typed, in the units of the table, or the problem with it. */
type ReadNumber = { readonly value: number } | { readonly problem: string };

/** Reads one typed number: converts it to the units of the table and checks the limits of its parameter. */
function readTypedNumber({ entry, scale }: Extract<BatchSetting, { kind: "number" }>, typed: string): ReadNumber {
	const number = readTyped(typed);
	if (!entry) {
		const isUsable = Number.isFinite(number) && Math.abs(number) <= LARGEST_CONSTANT;
		return isUsable ? { value: number } : { problem: text("batch_number") };
	}
	const value = parseDisplayed(entry, typed, number) / scale.per;
	const isWhole = entry.kind === "integer" && scale.per === 1;
	// Limits are shown with few decimals: a shown limit is accepted.
	const tolerance = 0.5 / 10 ** scale.decimals / scale.per;
	const isWithin = value >= entry.min - tolerance && value <= entry.max + tolerance;
	if (isWithin && !(isWhole && !Number.isInteger(value))) return { value: nearestWithin(entry, value) };
	const limits = {
		least: String(displayedNumber(scale, entry.min)),
		most: `${displayedNumber(scale, entry.max)} ${scale.unit}`.trim(),
	};
	return { problem: text(isWhole ? "batch_whole_number_within" : "batch_number_within", limits) };
}

/** Reads all numbers of a row; returns the problem of the first one that cannot be used, with its index `at`. */
function readNumbers(setting: Extract<BatchSetting, { kind: "number" }>, { variation, values }: BatchRow) {
	const typed = variation === "list" ? values[0].split(SEPARATOR).filter(Boolean) : values;
	const read = typed.map((each) => readTypedNumber(setting, each));
	const at = read.findIndex((each) => "problem" in each);
	const wrong = read[at];
	if (wrong && "problem" in wrong) return { problem: wrong.problem, at };
	return { numbers: read.flatMap((each) => ("value" in each ? each.value : [])) };
}

/** A row in the syntax of `--vary`, or its problem in words; `at` is the index of the field to correct. */
export type ReadRow = { readonly vary: string } | { readonly problem: string; readonly at: number };

/** Reads a row. */
export function readRow(setting: BatchSetting, row: BatchRow): ReadRow {
	const { key, values, variation } = row;
	if (setting.kind !== "number") {
		if (values.length === 0) return { problem: text("batch_no_choice"), at: 0 };
		return { vary: `${key}=${values.join("|")}` };
	}
	const read = readNumbers(setting, row);
	if (read.problem !== undefined) return { problem: read.problem, at: variation === "list" ? 0 : read.at };
	const { numbers } = read;
	if (variation !== "range") {
		if (numbers.length === 0) return { problem: text("batch_no_number"), at: 0 };
		return { vary: `${key}=${numbers.join("|")}` };
	}
	const [from, to] = numbers;
	if (from > to) return { problem: text("batch_backwards"), at: 1 };
	return { vary: `${key}=${from}..${to}` };
}

/**
 * Returns the text that a number's field shows after typing: the accepted numbers, or the typed text if one is not
 * usable.
 */
export function acceptedText(setting: BatchSetting, row: BatchRow, typed: string): string {
	if (setting.kind !== "number") return typed;
	const variation = row.variation === "list" ? "list" : "fixed";
	const read = readNumbers(setting, { ...row, variation, values: [typed] });
	if (read.problem !== undefined) return typed;
	const { entry = {}, scale } = setting;
	// Constants have no limited number of decimals.
	const shown = (value: number) => (setting.entry ? displayedText(entry, scale, value) : String(value));
	return read.numbers.map(shown).join("; ");
}
