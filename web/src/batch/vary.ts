/**
 * Parameters that vary between the plants of a series: `age=60..110,density=3..8,fruit=lychee
 * duku`.
 */
import { keyAndValue, splitAtFirst } from "../specimen/halves";
import type { ModelSchema } from "../specimen/model_schema";
import { readNumber } from "../specimen/read_values";
import { type Restored, restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { nearestWithin, onStep, type ParameterEntry } from "../specimen/table";
import type { Draws } from "./draws";
import { Unusable } from "./unusable";

/** A parameter and its values: a range of numbers, or a list. */
export type Varied = {
	readonly entry: ParameterEntry;
	/** Whether it is a name in the text, rather than a parameter (`named` in specimen/model_schema.ts). */
	readonly own?: true;
} & ({ readonly from: number; readonly to: number } | { readonly values: readonly string[] });

/**
 * @param from the specimen of all plants, without varied values
 * @throws Unusable
 */
export function readVary<S extends Specimen>(species: ModelSchema<S>, text: string, from: S): Varied[] {
	const varied = text.split(",").map((part) => readOne(species, part.trim(), from));
	const keys = varied.map(({ entry }) => entry.key);
	const twice = keys.find((key, index) => keys.indexOf(key) < index);
	if (twice !== undefined) throw new Unusable(`${twice} is given twice`);
	return varied;
}

function readOne<S extends Specimen>(species: ModelSchema<S>, part: string, from: S): Varied {
	const [key, values] = keyAndValue(part) ?? [];
	if (!key || !values) throw new Unusable(`“${part}”: write KEY=FROM..TO or KEY=ONE|ANOTHER, as in age=60..110`);
	const entry = entryOf(species, key) ?? constantOf(key);
	const own = entryOf(species, key) ? {} : ({ own: true } as const);
	const [low, high] = splitAtFirst(values, "..") ?? [];
	if (low === undefined || high === undefined) {
		const list = values.split("|").map((value) => value.trim());
		for (const value of list) check(species, { entry, own }, value, from);
		return { entry, ...own, values: list };
	}
	if (entry.kind === "choice" || entry.kind === "colour") {
		const some = entry.kind === "choice" ? entry.options.slice(0, 2).join("|") : "43264f|88aa44";
		throw new Unusable(`${key} has no values between two others; write ${key}=${some}`);
	}
	for (const value of [low, high]) check(species, { entry, own }, value, from);
	const [least, most] = [readNumber(low) ?? 0, readNumber(high) ?? 0];
	if (least > most) throw new Unusable(`${part} runs backwards; write ${key}=${most}..${least}`);
	return { entry, ...own, from: least, to: most };
}

/** The parameter of that key; undefined where it may be a name in the text. */
function entryOf<S extends Specimen>({ table, details }: ModelSchema<S>, key: string): ParameterEntry | undefined {
	const entry = table.entry(key);
	if (entry) return entry;
	const [first, ...others] = table.linked(key);
	if (others.length > 0) {
		throw new Unusable(
			`${key} is ${others.length + 1} numbers; vary ${[first, ...others].map((each) => each.key).join(" or ")}`,
		);
	}
	if (first) return first;
	const isDetail = details.some(({ keys }) => keys.includes(key));
	if (!isDetail && details.some(({ named }) => named)) return undefined;
	const known = isDetail ? "is no parameter, and cannot be varied" : "no parameter has that key";
	throw new Unusable(`${key}: ${known}; see --help or the parameters' page`);
}

/** A parameter for a name in the text: of any size and precision. */
const constantOf = (key: string): ParameterEntry => ({
	...{ key, link: key, label: key, symbol: "", group: "", unit: "", help: "", since: 1 },
	...{ kind: "number", min: Number.NEGATIVE_INFINITY, max: Number.POSITIVE_INFINITY, default: 0, step: 0 },
});

/** The specimen with varied values. */
export function withVaried<S extends Specimen>(
	species: ModelSchema<S>,
	from: S,
	values: readonly (readonly [Varied, value: string])[],
): Restored<S> {
	const [own, parameters] = [true, false].map((named) =>
		Object.fromEntries(
			values.filter(([of]) => (of.own ?? false) === named).map(([{ entry }, value]) => [entry.key, value]),
		),
	);
	const { specimen, notes } = restore(species, parameters, from);
	if (Object.keys(own).length === 0) return { specimen, notes };
	const named = species.details.find(({ named }) => named)?.named?.(specimen, own);
	const all = restore(species, named, specimen);
	return { specimen: all.specimen, notes: [...notes, ...all.notes] };
}

/**
 * Refuses names that the text does not have.
 * @throws Unusable
 */
export async function checkVaried<S extends Specimen>(
	species: ModelSchema<S>,
	varied: readonly Varied[],
	from: S,
): Promise<void> {
	const own = varied.filter((each) => each.own).map(({ entry }) => entry.key);
	const stranger = await species.details.find(({ unknownName }) => unknownName)?.unknownName?.(from, own);
	if (stranger) throw new Unusable(`${stranger.name}: no parameter has that key, and ${stranger.problem}`);
}

/** Refuses values that would be changed. */
function check<S extends Specimen>(
	species: ModelSchema<S>,
	{ entry, own }: { entry: ParameterEntry; own: { own?: true } },
	value: string,
	from: S,
): void {
	const varied = { entry, ...own, values: [] };
	const [note] = withVaried(species, from, [[varied, value]]).notes;
	if (note) throw new Unusable(`${entry.key}: ${note.problem}`);
	if (own.own) return;
	const number = entry.kind === "colour" ? undefined : readNumber(value);
	if (number !== undefined && onStep(number) !== number) {
		throw new Unusable(`${entry.key}: ${value} has more than two decimals`);
	}
}

/** The value of a plant, as links write it: drawn by its number, the key and the allowed values. */
export function drawn(varied: Varied, number: number, draws: Draws): string {
	const share = draws.share(`vary ${varied.entry.key}`, number);
	if ("values" in varied) return varied.values[Math.floor(share * varied.values.length)];
	const { entry, from, to } = varied;
	if (entry.kind === "colour") throw new RangeError("Colours have no range.");
	if (entry.kind === "integer") return String(from + Math.floor(share * (to - from + 1)));
	const value = from + share * (to - from);
	return String(varied.own ? Number(value.toPrecision(6)) : nearestWithin(entry, value));
}
