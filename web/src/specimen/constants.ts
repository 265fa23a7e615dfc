/** The field of models whose texts have constants: values that replace those of their `#define`s. */

import type { Message } from "../locale/texts";
import { text } from "./messages.generated";
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
export const MAX_CONSTANTS = 200;
/** A name in the notation (docs/language.md). */
const NAME = /^\p{L}[\p{L}\p{N}_]{0,63}$/u;
/** The largest absolute value: beyond it no drawing can be seen. */
export const LARGEST_CONSTANT = 1e9;

/** Returns whether links and files can hold this value for this name. */
export const isStorableConstant = (name: string, value: number): boolean =>
	NAME.test(name) && Math.abs(value) <= LARGEST_CONSTANT && (value === 0 || Math.fround(value) !== 0);

/**
 * Creates the field.
 * @param names lists the constants that a specimen's text defines, once it has been fetched
 */
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
			const [written, before] = [own, preset.constants].map(writeConstants);
			return written === before ? [] : [["define", written]];
		},
		named: ({ constants: own }, values) => ({ constants: { ...own, ...values } }),
		names,
		unknownName: async (specimen, given = Object.keys(specimen.constants)) => {
			const known = await names(specimen);
			const name = given.find((each) => !known.includes(each));
			if (name === undefined) return undefined;
			return { name, problem: undefinedConstant(known) };
		},
	};
}

const MAX_SHOWN = 20;

/**
 * Returns the message on a constant that a text does not define.
 * @param known the constants that it defines
 */
function undefinedConstant(known: readonly string[]): Message {
	if (known.length === 0) return text.message("no_constants");
	const names = known.slice(0, MAX_SHOWN).join(", ");
	const count = known.length - MAX_SHOWN;
	return count > 0
		? text.message("constant_undefined_more", { names, count })
		: text.message("constant_undefined", { names });
}

/** Returns constants as a query has them: `angle:30,n:5`. */
function writeConstants(values: ConstantValues): string {
	return Object.entries(values)
		.map(([name, value]) => `${encodeURIComponent(name)}:${encodeURIComponent(value)}`)
		.join(",");
}

/**
 * Reads the text `angle:30,n:5`, or a record of numbers; notes unusable constants and leaves them out.
 * @param key the key of the field, for notes
 */
function readConstants(key: string, value: unknown, notes: Notes): ConstantValues {
	const found = new Map<string, number>();
	for (const [name, given] of pairsOf(value)) {
		const number = readNumber(given);
		if (!NAME.test(name)) notes.add(key, text.message("not_a_constant", { value: quote(name) }), text("left_out"));
		else if (number === undefined || !(Math.abs(number) <= LARGEST_CONSTANT))
			notes.add(key, text.message("constant_not_a_number", { name, value: quote(given) }), text("text_value_used"));
		else if (found.size >= MAX_CONSTANTS && !found.has(name)) {
			notes.add(
				key,
				text.message("too_many_constants", { most: MAX_CONSTANTS }),
				text("first_used", { most: MAX_CONSTANTS }),
			);
			break;
		} else found.set(name, Math.fround(number) === 0 ? 0 : number);
	}
	return sortedConstants([...found]);
}

/** Constants in alphabetical order: equal values make equal documents. */
export function sortedConstants(values: readonly (readonly [name: string, value: number])[]): ConstantValues {
	return Object.fromEntries([...values].sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** Splits a text `angle:30,n:5` or a record into names and values, unchecked. */
function pairsOf(value: unknown): (readonly [string, unknown])[] {
	if (isRecord(value)) return Object.entries(value);
	if (typeof value !== "string" || value.trim() === "") return typeof value === "string" ? [] : [["", value]];
	return value.split(",").map((pair) => {
		const separator = pair.lastIndexOf(":");
		return [pair.slice(0, Math.max(0, separator)).trim(), pair.slice(separator + 1)] as const;
	});
}
