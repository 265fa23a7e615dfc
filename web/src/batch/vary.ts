/**
 * Parameters that vary between the plants of a series: `age=60..110,density=3..8,fruit=lychee
 * duku`.
 */
import { formatList } from "../locale/format";
import { keyAndValue, splitAtFirst } from "../specimen/halves";
import type { ModelSchema } from "../specimen/model_schema";
import { readNumber } from "../specimen/read_values";
import { type Restored, restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { nearestWithin, onStep, type ParameterEntry } from "../specimen/table";
import type { Draws } from "./draws";
import { text } from "./messages.generated";
import { Unusable } from "./unusable";

/** A parameter and its values: a range of numbers, or a list. */
export type Varied = {
	readonly entry: ParameterEntry;
	/** Whether it is a name in the text, rather than a parameter (`named` in specimen/model_schema.ts). */
	readonly own?: true;
} & ({ readonly from: number; readonly to: number } | { readonly values: readonly string[] });

/**
 * Reads the text of `--vary`: parameters and the values that each varies over.
 * @param from the specimen of all plants, without varied values
 * @throws Unusable
 */
export function readVary<S extends Specimen>(schema: ModelSchema<S>, written: string, from: S): Varied[] {
	const varied = written.split(",").map((part) => readOne(schema, part.trim(), from));
	const keys = varied.map(({ entry }) => entry.key);
	const twice = keys.find((key, index) => keys.indexOf(key) < index);
	if (twice !== undefined) throw new Unusable(text.message("vary_twice", { key: twice }));
	return varied;
}

/**
 * Reads one varied parameter, `KEY=FROM..TO` or `KEY=VALUE|VALUE`; a key that is no parameter's is a constant of the
 * text.
 * @throws Unusable if it cannot be read, or if a value does not fit
 */
function readOne<S extends Specimen>(schema: ModelSchema<S>, part: string, from: S): Varied {
	const [key, values] = keyAndValue(part) ?? [];
	if (!key || !values) throw new Unusable(text.message("vary_unreadable", { part }));
	const entry = entryOf(schema, key) ?? constantOf(key);
	const own = entryOf(schema, key) ? {} : ({ own: true } as const);
	const [low, high] = splitAtFirst(values, "..") ?? [];
	if (low === undefined || high === undefined) {
		const list = values.split("|").map((value) => value.trim());
		for (const value of list) check(schema, { entry, own }, value, from);
		return { entry, ...own, values: list };
	}
	if (entry.kind === "choice" || entry.kind === "colour") {
		const some = entry.kind === "choice" ? entry.options.slice(0, 2).join("|") : "43264f|88aa44";
		throw new Unusable(text.message("vary_no_range", { key, example: `${key}=${some}` }));
	}
	for (const value of [low, high]) check(schema, { entry, own }, value, from);
	const [least, most] = [readNumber(low) ?? 0, readNumber(high) ?? 0];
	if (least > most) {
		const corrected = `${key}=${most}..${least}`;
		throw new Unusable(text.message("range_backwards", { range: part, corrected }));
	}
	return { entry, ...own, from: least, to: most };
}

/** Returns the parameter of that key; undefined where it may be a name in the text. */
function entryOf<S extends Specimen>({ table, details }: ModelSchema<S>, key: string): ParameterEntry | undefined {
	const entry = table.entry(key);
	if (entry) return entry;
	const [first, ...others] = table.linked(key);
	if (others.length > 0) {
		const keys = formatList(
			[first, ...others].map((each) => each.key),
			"disjunction",
		);
		throw new Unusable(text.message("vary_several", { key, keys }));
	}
	if (first) return first;
	const isDetail = details.some(({ keys }) => keys.includes(key));
	if (!isDetail && details.some(({ named }) => named)) return undefined;
	throw new Unusable(text.message(isDetail ? "vary_not_parameter" : "vary_unknown", { key }));
}

/** Returns a parameter for a name in the text: of any size and precision. */
const constantOf = (key: string): ParameterEntry => ({
	...{ key, link: key, label: key, symbol: "", group: "", unit: "", help: "", since: 1 },
	...{ kind: "number", min: Number.NEGATIVE_INFINITY, max: Number.POSITIVE_INFINITY, default: 0, step: 0 },
});

/** Returns the specimen with varied values. */
export function withVaried<S extends Specimen>(
	schema: ModelSchema<S>,
	from: S,
	values: readonly (readonly [Varied, value: string])[],
): Restored<S> {
	const [own, parameters] = [true, false].map((named) =>
		Object.fromEntries(
			values.filter(([of]) => (of.own ?? false) === named).map(([{ entry }, value]) => [entry.key, value]),
		),
	);
	const { specimen, notes } = restore(schema, parameters, from);
	if (Object.keys(own).length === 0) return { specimen, notes };
	const named = schema.details.find(({ named }) => named)?.named?.(specimen, own);
	const all = restore(schema, named, specimen);
	return { specimen: all.specimen, notes: [...notes, ...all.notes] };
}

/**
 * Refuses names that the text does not have.
 * @throws Unusable
 */
export async function checkVaried<S extends Specimen>(
	schema: ModelSchema<S>,
	varied: readonly Varied[],
	from: S,
): Promise<void> {
	const own = varied.filter((each) => each.own).map(({ entry }) => entry.key);
	const stranger = await schema.details.find(({ unknownName }) => unknownName)?.unknownName?.(from, own);
	if (!stranger) return;
	const { name: key, problem } = stranger;
	throw new Unusable(text.message("vary_unknown_in_text", { key, problem: problem.text }));
}

/**
 * Refuses a value that would be changed when it is set.
 * @param own whether the key is a name in the text
 * @throws Unusable
 */
function check<S extends Specimen>(
	schema: ModelSchema<S>,
	{ entry, own }: { entry: ParameterEntry; own: { own?: true } },
	value: string,
	from: S,
): void {
	const varied = { entry, ...own, values: [] };
	const [note] = withVaried(schema, from, [[varied, value]]).notes;
	if (note) throw new Unusable(text.message("vary_value", { key: entry.key, problem: note.problem }));
	if (own.own) return;
	const number = entry.kind === "colour" ? undefined : readNumber(value);
	if (number !== undefined && onStep(number) !== number) {
		throw new Unusable(text.message("vary_decimals", { key: entry.key, value }));
	}
}

/** Returns the value of a plant, as links write it: drawn by its number, the key and the allowed values. */
export function drawn(varied: Varied, number: number, draws: Draws): string {
	const share = draws.share(`vary ${varied.entry.key}`, number);
	if ("values" in varied) return varied.values[Math.floor(share * varied.values.length)];
	const { entry, from, to } = varied;
	if (entry.kind === "colour") throw new RangeError("Colours have no range.");
	if (entry.kind === "integer") return String(from + Math.floor(share * (to - from + 1)));
	const value = from + share * (to - from);
	return String(varied.own ? Number(value.toPrecision(6)) : nearestWithin(entry, value));
}
