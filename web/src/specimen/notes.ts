/** A note on one part of data from outside: the problem, and the value used in its place. */
export interface Note {
	/** The name of the part in that data. */
	key: string;
	/** The problem in plain words: "700 is above the greatest value, 580". */
	problem: string;
	/** The whole sentence to show: "l: 700 is above the greatest value, 580; 580 is used." */
	text: string;
}

/** The most notes; the others are summed up in a last one, so that a hostile link cannot fill the page. */
const MOST_NOTES = 12;
const LONGEST_QUOTE = 32;

/** Collects notes in the order in which parts are read. */
export class Notes {
	readonly #list: Note[] = [];
	#left = 0;

	add(key: string, problem: string, outcome: string): void {
		if (this.#list.length >= MOST_NOTES) {
			this.#left++;
			return;
		}
		const name = cut(key);
		this.#list.push({ key: name, problem, text: `${name}: ${problem}; ${outcome}.` });
	}

	all(): Note[] {
		if (this.#left === 0) return this.#list;
		const problem = `${this.#left} more parts could not be used`;
		return [...this.#list, { key: "", problem, text: `${problem}.` }];
	}
}

/** Quotes a value in a note: short, on one line. */
export function quote(value: unknown): string {
	if (typeof value === "string") return `“${cut(value)}”`;
	if (typeof value === "number" || typeof value === "boolean") return String(value);
	return Array.isArray(value) ? "a list" : "an object";
}

function cut(text: string): string {
	const line = text.replace(/\p{C}/gu, " ");
	return line.length > LONGEST_QUOTE ? `${line.slice(0, LONGEST_QUOTE)}…` : line;
}
