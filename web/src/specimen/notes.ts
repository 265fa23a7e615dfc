import type { Message } from "../locale/texts";
import { text } from "./messages.generated";

/** A note on one part of data from outside: the problem, and the value used in its place. */
export interface Note {
	/** The name of the part in that data. */
	key: string;
	/** The problem as a sentence: "700 is above the maximum, 580." */
	problem: string;
	/** The sentences to show: "l: 700 is above the maximum, 580. Using 580." */
	text: string;
	/** The code of the problem: "specimen.above_maximum". */
	code: string;
	/** The arguments of the problem by name. */
	args: Message["args"];
}

/** The most notes; the others are summed up in a last one, so that a hostile link cannot fill the page. */
const MAX_NOTES = 12;
const LONGEST_QUOTE = 32;

/** Collects notes in the order in which parts are read. */
export class Notes {
	readonly #list: Note[] = [];
	#left = 0;

	/**
	 * Adds a note; beyond `MAX_NOTES`, only counts it.
	 * @param key name of the part in the data
	 * @param problem a sentence
	 * @param outcome a sentence on the value used instead
	 */
	add(key: string, problem: Message, outcome: string): void {
		if (this.#list.length >= MAX_NOTES) {
			this.#left++;
			return;
		}
		const name = cut(key);
		const note = text("note", { key: name, problem: problem.text, outcome });
		this.#list.push({ key: name, problem: problem.text, text: note, code: problem.code, args: problem.args });
	}

	/** Returns the notes in order; a last one counts those that are left out. */
	all(): Note[] {
		if (this.#left === 0) return this.#list;
		const { code, args, text: problem } = text.message("more_notes", { count: this.#left });
		return [...this.#list, { key: "", problem, text: problem, code, args }];
	}
}

/** Quotes a value in a note: short, on one line. */
export function quote(value: unknown): string {
	if (typeof value === "string") return `“${cut(value)}”`;
	if (typeof value === "number" || typeof value === "boolean") return String(value);
	return text(Array.isArray(value) ? "a_list" : "an_object");
}

/** Shortens a value to one line of at most `LONGEST_QUOTE` characters. */
function cut(value: string): string {
	const line = value.replace(/\p{C}/gu, " ");
	return line.length > LONGEST_QUOTE ? `${line.slice(0, LONGEST_QUOTE)}…` : line;
}
