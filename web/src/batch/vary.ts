/** What is varied from plant to plant of a series: `age=60..110,density=3..8,fruit=lychee|duku`. */
import { readNumber } from "../specimen/read_values";
import { restore } from "../specimen/restore";
import type { Species } from "../specimen/species";
import type { Specimen } from "../specimen/specimen";
import { type Entry, nearestWithin, onStep } from "../specimen/table";
import { Unusable } from "./unusable";

/** A parameter and where its values come from: anywhere from one number to another, or one of a few. */
export type Varied = { readonly entry: Entry } & (
	| { readonly from: number; readonly to: number }
	| { readonly values: readonly string[] }
);

/**
 * @param from the specimen that all plants have but for what is varied
 * @throws Unusable
 */
export function readVary<S extends Specimen>(species: Species<S>, text: string, from: S): Varied[] {
	const varied = text.split(",").map((part) => readOne(species, part.trim(), from));
	const keys = varied.map(({ entry }) => entry.key);
	const twice = keys.find((key, index) => keys.indexOf(key) < index);
	if (twice !== undefined) throw new Unusable(`${twice} is given twice`);
	return varied;
}

function readOne<S extends Specimen>(species: Species<S>, part: string, from: S): Varied {
	const [, key, values] = /^([^=\s]+)\s*=\s*(.+)$/.exec(part) ?? [];
	if (key === undefined) throw new Unusable(`“${part}”: write KEY=FROM..TO or KEY=ONE|ANOTHER, as in age=60..110`);
	const entry = entryOf(species, key);
	const [, low, high] = /^(.*?)\.\.(.*)$/.exec(values) ?? [];
	if (low === undefined) {
		const list = values.split("|").map((value) => value.trim());
		for (const value of list) check(species, entry, value, from);
		return { entry, values: list };
	}
	if (entry.kind === "choice" || entry.kind === "colour") {
		const some = entry.kind === "choice" ? entry.options.slice(0, 2).join("|") : "43264f|88aa44";
		throw new Unusable(`${key} has no values between two others; write ${key}=${some}`);
	}
	for (const value of [low, high]) check(species, entry, value, from);
	const [least, most] = [readNumber(low) ?? 0, readNumber(high) ?? 0];
	if (least > most) throw new Unusable(`${part} runs backwards; write ${key}=${most}..${least}`);
	return { entry, from: least, to: most };
}

function entryOf<S extends Specimen>({ table, details }: Species<S>, key: string): Entry {
	const entry = table.entry(key);
	if (entry) return entry;
	const [first, ...others] = table.linked(key);
	if (others.length > 0) {
		throw new Unusable(
			`${key} is ${others.length + 1} numbers; vary ${[first, ...others].map((each) => each.key).join(" or ")}`,
		);
	}
	if (first) return first;
	const known = details.some(({ keys }) => keys.includes(key))
		? "is no parameter, and cannot be varied"
		: "no parameter has that key";
	throw new Unusable(`${key}: ${known}; see --help or the parameters' page`);
}

/** Refuses what would not be used as it is. */
function check<S extends Specimen>(species: Species<S>, entry: Entry, value: string, from: S): void {
	const [note] = restore(species, { [entry.key]: value }, from).notes;
	if (note) throw new Unusable(`${entry.key}: ${note.problem}`);
	const number = entry.kind === "colour" ? undefined : readNumber(value);
	if (number !== undefined && onStep(number) !== number) {
		throw new Unusable(`${entry.key}: ${value} has more than two decimals`);
	}
}

/** The value that a seed has, as links write it: of nothing but the seed, the key and what is allowed. */
export function drawn(varied: Varied, seed: number): string {
	const share = shareOf(varied.entry.key, seed);
	if ("values" in varied) return varied.values[Math.floor(share * varied.values.length)];
	const { entry, from, to } = varied;
	if (entry.kind === "colour") throw new RangeError("Colours have no range.");
	if (entry.kind === "integer") return String(from + Math.floor(share * (to - from + 1)));
	return String(nearestWithin(entry, from + share * (to - from)));
}

/** A number from 0 up to but not 1, as good as drawn by lot. */
function shareOf(key: string, seed: number): number {
	let bits = 0x811c9dc5;
	for (const char of key) bits = Math.imul(bits ^ (char.codePointAt(0) ?? 0), 0x01000193);
	return mixed(mixed(bits) ^ seed) / 2 ** 32;
}

/** Every bit depends on every other (Appleby 2011, the end of MurmurHash3). */
function mixed(bits: number): number {
	let h = bits;
	h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
	return (h ^ (h >>> 16)) >>> 0;
}
