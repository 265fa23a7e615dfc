/** Values for a text's own constants, in place of what its `#define`s say. */
import { type Notes, quote } from "../../../specimen/notes";
import { isRecord, readNumber } from "../../../specimen/read_values";
import type { Detail } from "../../../specimen/species";
import type { GrammarSpecimen } from "../specimen";

/** As many as a text of any sense has. */
export const MOST_CONSTANTS = 200;
/** A name as the notation has it (docs/language.md). */
const NAME = /^\p{L}[\p{L}\p{N}_]{0,63}$/u;
/** Beyond these nothing is drawn that could be seen. */
const LARGEST = 1e9;

export const constants: Detail<GrammarSpecimen> = {
	keys: ["define", "constants"],
	settings: ["define=NAME:VALUE,…"],
	fresh: () => ({ constants: {} }),
	read: (specimen, key, value, notes) => {
		specimen.constants = readConstants(key, value, notes);
	},
	query: ({ constants: own }, preset) => {
		const [written, before] = [own, preset.constants].map(write);
		return written === before ? [] : [["define", written]];
	},
	named: ({ constants: own }, values) => ({ constants: { ...own, ...values } }),
};

/** `angle:30,n:5`, as a query has it. */
function write(values: Readonly<Record<string, number>>): string {
	return Object.entries(values)
		.map(([name, value]) => `${encodeURIComponent(name)}:${encodeURIComponent(value)}`)
		.join(",");
}

/** Reads such a text, or a record of numbers. */
function readConstants(key: string, value: unknown, notes: Notes): Record<string, number> {
	const found = new Map<string, number>();
	for (const [name, given] of pairsOf(value)) {
		const number = readNumber(given);
		if (!NAME.test(name)) notes.add(key, `${quote(name)} is not a constant’s name`, "left out");
		else if (number === undefined || !(Math.abs(number) <= LARGEST))
			notes.add(key, `${name} is ${quote(given)}, which is not a number`, "what the text says is used");
		else if (found.size >= MOST_CONSTANTS && !found.has(name)) {
			notes.add(key, `more than ${MOST_CONSTANTS} constants`, `the first ${MOST_CONSTANTS} are read`);
			break;
		} else found.set(name, Math.fround(number) === 0 ? 0 : number);
	}
	return Object.fromEntries([...found].sort(([a], [b]) => (a < b ? -1 : 1)));
}

function pairsOf(value: unknown): (readonly [string, unknown])[] {
	if (isRecord(value)) return Object.entries(value);
	if (typeof value !== "string" || value.trim() === "") return typeof value === "string" ? [] : [["", value]];
	return value.split(",").map((pair) => {
		const at = pair.lastIndexOf(":");
		return [pair.slice(0, Math.max(0, at)).trim(), pair.slice(at + 1)] as const;
	});
}
