/**
 * A history as one text: steps as the queries of their links, long texts once each, and texts that resemble another as
 * their difference from it. Both the text and the work of reading it are limited.
 */

import { LONGEST_HISTORY } from "../../specimen/history";
import { LONGEST_QUERY } from "../../specimen/link";
import type { StoredSpecimen } from "./stored_specimen";

/** A history of specimens in their stored form. */
export interface StoredHistory {
	/** Nearest to the present first, as in `future`. */
	readonly past: readonly StoredSpecimen[];
	readonly present: StoredSpecimen;
	readonly future: readonly StoredSpecimen[];
}

/** The most characters of the text; browsers give a tab five million. Steps far from the present are left out. */
export const LONGEST_TEXT = 1_000_000;
/** The most characters of all long texts together, while they are written or read: 200 of the longest grammars. */
const MOST_CHARACTERS = 64_000_000;
const VERSION = 1;

/** A long text, or the number of an earlier one, the lengths of its beginning and end, and the text between them. */
type Piece = string | readonly [base: number, start: number, end: number, middle: string];

/** A step: the query, the numbers of the long texts by key, and that of the extra fields. */
interface StepRecord {
	readonly q: string;
	readonly t?: Readonly<Record<string, number>>;
	readonly x?: number;
}

interface HistoryRecord {
	readonly v: typeof VERSION;
	readonly pieces: readonly Piece[];
	readonly present: StepRecord;
	readonly past: readonly StepRecord[];
	readonly future: readonly StepRecord[];
}

/**
 * Writes a history; undefined if its present alone is too long.
 * @param most the most characters; steps that do not fit are left out, those to redo first
 */
export function writeHistory({ past, present, future }: StoredHistory, most = LONGEST_TEXT): string | undefined {
	const pieces = new PieceWriter(most);
	const first = pieces.step(present);
	if (!first) return undefined;
	const run = (steps: readonly StoredSpecimen[]): StepRecord[] => {
		const written: StepRecord[] = [];
		let near = first;
		for (const each of steps.slice(0, LONGEST_HISTORY)) {
			const step = pieces.step(each, near);
			if (!step) break;
			written.push(step);
			near = step;
		}
		return written;
	};
	const record: HistoryRecord = {
		v: VERSION,
		present: first,
		past: run(past),
		future: run(future),
		pieces: pieces.pieces,
	};
	return JSON.stringify(record);
}

/** Reads a history from a text of any origin; undefined where it is none. Steps behind an invalid one are left out. */
export function readHistory(text: string): StoredHistory | undefined {
	if (text.length > LONGEST_TEXT) return undefined;
	try {
		const { v, pieces, present, past, future } = JSON.parse(text) as HistoryRecord;
		if (v !== VERSION) return undefined;
		const reader = new PieceReader(pieces);
		return { present: reader.step(present), past: reader.steps(past), future: reader.steps(future) };
	} catch {
		return undefined;
	}
}

/** Room for the names of the record and its punctuation. */
const FRAME = 100;

/** Collects the long texts of steps. */
class PieceWriter {
	readonly pieces: Piece[] = [];
	readonly #texts: string[] = [];
	readonly #numbers = new Map<string, number>();
	#left: number;
	#work = MOST_CHARACTERS;

	constructor(most: number) {
		this.#left = most - FRAME;
	}

	/**
	 * Writes a step; undefined, and nothing is added, if it does not fit.
	 * @param near a step whose texts probably resemble those of this one
	 */
	step({ query, texts, extra }: StoredSpecimen, near?: StepRecord): StepRecord | undefined {
		const [count, left] = [this.pieces.length, this.#left];
		const numbers = Object.entries(texts).map(([key, text]) => [key, this.#numberOf(text, near?.t?.[key])] as const);
		const step = {
			q: query,
			...(numbers.length > 0 ? { t: Object.fromEntries(numbers) } : {}),
			...(extra === undefined ? {} : { x: this.#numberOf(extra, near?.x) }),
		};
		this.#left -= JSON.stringify(step).length + 1;
		if (this.#left >= 0 && this.#work >= 0) return step;
		for (const text of this.#texts.splice(count)) this.#numbers.delete(text);
		this.pieces.length = count;
		this.#left = left;
		return undefined;
	}

	/**
	 * Returns the number of a text, which is added if it is new.
	 * @param base the number of a text that resembles it
	 */
	#numberOf(text: string, base: number | undefined): number {
		const known = this.#numbers.get(text);
		if (known !== undefined) return known;
		this.#work -= text.length;
		const number = this.#texts.push(text) - 1;
		this.#numbers.set(text, number);
		const piece = base === undefined ? text : difference(text, this.#texts[base], base);
		this.pieces.push(piece);
		this.#left -= JSON.stringify(piece).length + 1;
		return number;
	}
}

/**
 * Returns the difference of a text from another: the lengths of the common beginning and end, and the text between
 * them.
 * @param base number of the other text
 */
function difference(text: string, other: string, base: number): Piece {
	const most = Math.min(text.length, other.length);
	let start = 0;
	while (start < most && text.charCodeAt(start) === other.charCodeAt(start)) start++;
	let end = 0;
	while (end < most - start && text.charCodeAt(text.length - 1 - end) === other.charCodeAt(other.length - 1 - end))
		end++;
	return [base, start, end, text.slice(start, text.length - end)];
}

/** Expands the long texts of steps. Throws where the record is invalid or expands to too much. */
class PieceReader {
	readonly #texts: string[] = [];
	#left = MOST_CHARACTERS;

	constructor(pieces: unknown) {
		if (!Array.isArray(pieces)) throw new TypeError("no list");
		for (const piece of pieces) {
			const text = this.#expand(piece);
			this.#left -= text.length;
			if (this.#left < 0) throw new RangeError("too long");
			this.#texts.push(text);
		}
	}

	/** Reads steps up to the first that is invalid. */
	steps(records: unknown): StoredSpecimen[] {
		const read: StoredSpecimen[] = [];
		if (!Array.isArray(records)) return read;
		for (const record of records.slice(0, LONGEST_HISTORY)) {
			try {
				read.push(this.step(record));
			} catch {
				break;
			}
		}
		return read;
	}

	/** Reads a step; throws where it is invalid. */
	step(record: unknown): StoredSpecimen {
		const { q, t = {}, x } = record as StepRecord;
		if (typeof q !== "string" || q.length > LONGEST_QUERY) throw new TypeError("no query");
		const texts = Object.fromEntries(Object.entries(t).map(([key, number]) => [key, this.#textOf(number)]));
		return { query: q, texts, ...(x === undefined ? {} : { extra: this.#textOf(x) }) };
	}

	/** Returns the long text of a number; throws where there is none. */
	#textOf(number: unknown): string {
		const text = typeof number === "number" ? this.#texts[number] : undefined;
		if (text === undefined) throw new TypeError("no text");
		return text;
	}

	/** Returns a long text from its piece; throws where the piece is invalid. */
	#expand(piece: unknown): string {
		if (typeof piece === "string") return piece;
		const [base, start, end, middle] = piece as Exclude<Piece, string>;
		const other = this.#textOf(base);
		const fits = [start, end].every((length) => Number.isInteger(length) && length >= 0) && start + end <= other.length;
		if (!fits || typeof middle !== "string") throw new TypeError("no difference");
		return other.slice(0, start) + middle + other.slice(other.length - end);
	}
}
