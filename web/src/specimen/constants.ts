/** The field of models whose texts have constants: values that replace those of their `#define`s. */

import type { Field } from "./model_schema";
import { type Notes, quote } from "./notes";
import { isRecord, readNumber } from "./read_values";
import type { Specimen } from "./specimen";

/** A specimen with this field. */
export interface WithConstants {
	/** Values for the text's own constants by name, in alphabetical order; the text sets the others. */
	constants: ConstantValues;
}

export type ConstantValues = Readonly<Record<string, number>>;

/** The most constants that a specimen stores. */
export const MOST_CONSTANTS = 200;
/** A name in the notation (docs/language.md). */
const NAME = /^\p{L}[\p{L}\p{N}_]{0,63}$/u;
/** The largest absolute value: beyond it no drawing can be seen. */
export const LARGEST_CONSTANT = 1e9;

/** Whether links and files can hold this value for this name. */
export const isStorableConstant = (name: string, value: number): boolean =>
	NAME.test(name) && Math.abs(value) <= LARGEST_CONSTANT && (value === 0 || Math.fround(value) !== 0);

/** @param names lists the constants that a specimen's text defines, once it has been fetched */
export function constantValues<S extends Specimen & WithConstants>(
	names: (specimen: S) => Promise<readonly string[]>,
): Field<S> {
	return {
		keys: ["define", "constants"],
		settings: ["define=NAME:VALUE,…"],
		fresh: () => ({ constants: {} }) as Partial<S>,
		read: (specimen, key, value, notes) => {
			specimen.constants = readConstants(key, value, notes);
		},
		query: ({ constants: own }, preset) => {
			const [written, before] = [own, preset.constants].map(write);
			return written === before ? [] : [["define", written]];
		},
		named: ({ constants: own }, values) => ({ constants: { ...own, ...values } }),
		unknownName: async (specimen, given = Object.keys(specimen.constants)) => {
			const known = await names(specimen);
			const name = given.find((each) => !known.includes(each));
			if (name === undefined) return undefined;
			const [shown, more] = [known.slice(0, MOST_SHOWN), known.length - MOST_SHOWN];
			const there = shown.length === 0 ? "there are none" : `there are ${shown.join(", ")}`;
			return { name, problem: `the text defines no such constant; ${there}${more > 0 ? ` and ${more} more` : ""}` };
		},
	};
}

const MOST_SHOWN = 20;

/** `angle:30,n:5`, as a query has it. */
function write(values: ConstantValues): string {
	return Object.entries(values)
		.map(([name, value]) => `${encodeURIComponent(name)}:${encodeURIComponent(value)}`)
		.join(",");
}

/** Reads such a text, or a record of numbers. */
function readConstants(key: string, value: unknown, notes: Notes): ConstantValues {
	const found = new Map<string, number>();
	for (const [name, given] of pairsOf(value)) {
		const number = readNumber(given);
		if (!NAME.test(name)) notes.add(key, `${quote(name)} is not a constant’s name`, "left out");
		else if (number === undefined || !(Math.abs(number) <= LARGEST_CONSTANT))
			notes.add(key, `${name} is ${quote(given)}, which is not a number`, "what the text says is used");
		else if (found.size >= MOST_CONSTANTS && !found.has(name)) {
			notes.add(key, `more than ${MOST_CONSTANTS} constants`, `the first ${MOST_CONSTANTS} are read`);
			break;
		} else found.set(name, Math.fround(number) === 0 ? 0 : number);
	}
	return sortedConstants([...found]);
}

/** Constants in alphabetical order: equal values make equal documents. */
export function sortedConstants(values: readonly (readonly [name: string, value: number])[]): ConstantValues {
	return Object.fromEntries([...values].sort(([a], [b]) => (a < b ? -1 : 1)));
}

function pairsOf(value: unknown): (readonly [string, unknown])[] {
	if (isRecord(value)) return Object.entries(value);
	if (typeof value !== "string" || value.trim() === "") return typeof value === "string" ? [] : [["", value]];
	return value.split(",").map((pair) => {
		const at = pair.lastIndexOf(":");
		return [pair.slice(0, Math.max(0, at)).trim(), pair.slice(at + 1)] as const;
	});
}
