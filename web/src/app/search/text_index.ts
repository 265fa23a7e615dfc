/**
 * Searches texts as people type: in any order of words, by their beginnings, in singular or plural, with synonyms, and
 * with one typo in a word where nothing else matches.
 */
import { isExact, isOneTypo, plain, referenceTo, singularOf, tokensOf } from "./words";

/** Where a text stands in an entry: its title, the shelf that holds it, or its description. Lower levels come first. */
export const TITLE = 0;
export const SHELF = 1;
export const DESCRIPTION = 2;
export type MatchLevel = typeof TITLE | typeof SHELF | typeof DESCRIPTION;

/** An entry of the index: its texts by level. */
export interface SearchTexts {
	/** As people see it: a query that equals it finds its entry first. */
	readonly title: string;
	/** Further titles, such as the name in links. */
	readonly names?: readonly string[];
	/** From the most important one. */
	readonly shelves?: readonly string[];
	readonly descriptions?: readonly string[];
	/** Names of shelves for synonyms, in no language: "family:grammars". */
	readonly keys?: readonly string[];
	/** Added to every score: the entry comes after those of the levels before. */
	readonly penalty?: number;
}

/** Other phrases for a phrase, or keys of shelves, best first; they are searched in titles and shelves. */
export type Synonyms = Readonly<Record<string, readonly string[]>>;

/** Distance of two levels in a score. */
const LEVEL = 10;
/** Costs of a match that is less than the word itself. */
const COST = { plural: 0.5, beginning: 1, synonym: 2, middle: 3, typo: 4 } as const;
/** Scores of entries whose title is the query, letter by letter or as words, and of those whose shelf is. */
const [SAME_LETTERS, SAME_WORDS, SAME_SHELF] = [-1000, -900, -500];
/** Cost of each word of a matching title, so that "Oak" comes before "Oak by the sea". */
const TITLE_WORD = 0.01;
/** Gain of an optional word of the query that is in the title. */
const OPTIONAL_WORD = 0.2;
/** Least letters of a word that may have a typo, and of one that is found inside other words. */
const [LEAST_FOR_TYPO, LEAST_FOR_MIDDLE] = [4, 4];
/** Most words of a phrase with synonyms. */
const LONGEST_PHRASE = 3;

/** Words that a result may lack. */
const OPTIONAL = new Set("a an and the of in on with for to de des du la le les l un une et en au aux avec".split(" "));

/** A word of the index, with the lowest level at which each entry has it. */
interface IndexedWord {
	readonly word: string;
	readonly singular: string;
	readonly levels: Map<number, MatchLevel>;
}

/** Scores by entry; lower ones are better. */
type Scores = ReadonlyMap<number, number>;

/** One of the ways to match a part of a query: all of its words. */
interface Alternative {
	readonly words: readonly string[];
	readonly synonym?: boolean;
	readonly cost: number;
}

/** Part of a query: a word or a phrase. */
interface Part {
	readonly optional: boolean;
	readonly alternatives: readonly Alternative[];
}

/** A search result with its score. */
export interface Scored<T> {
	readonly entry: T;
	/** Lower is better. */
	readonly score: number;
}

export class TextIndex<T> {
	readonly #entries: readonly T[];
	readonly #words = new Map<string, IndexedWord>();
	readonly #letters: readonly string[];
	readonly #titles: readonly (readonly string[])[];
	/** Positions of shelves among those of an entry, by their words. */
	readonly #shelves: readonly ReadonlyMap<string, number>[];
	readonly #penalties: readonly number[];
	readonly #synonyms: ReadonlyMap<string, readonly string[]>;

	/**
	 * @param entries in the order of equally good matches
	 * @param textsOf the searchable texts of an entry
	 */
	constructor(entries: readonly T[], textsOf: (entry: T) => SearchTexts, synonyms: Synonyms = {}) {
		this.#entries = entries;
		const texts = entries.map(textsOf);
		this.#letters = texts.map(({ title }) => lettersOf(title));
		this.#titles = texts.map(({ title }) => tokensOf(title));
		// The first of equal shelves counts.
		this.#shelves = texts.map(
			({ shelves = [] }) => new Map(shelves.map((shelf, i) => [phraseOf(tokensOf(shelf)), i] as const).reverse()),
		);
		this.#penalties = texts.map(({ penalty = 0 }) => penalty);
		this.#synonyms = new Map(Object.entries(synonyms).map(([phrase, others]) => [phraseOf(tokensOf(phrase)), others]));
		for (const [at, { title, names = [], shelves = [], descriptions = [], keys = [] }] of texts.entries()) {
			for (const text of [title, ...names]) this.#add(at, text, TITLE);
			for (const text of shelves) this.#add(at, text, SHELF);
			for (const text of descriptions) this.#add(at, text, DESCRIPTION);
			for (const key of keys) this.#addWord(at, key, SHELF);
		}
	}

	/** Returns the entries that match a query, best first; all of them for a query without words. */
	find(query: string): readonly T[] {
		return this.search(query).map(({ entry }) => entry);
	}

	/**
	 * Returns the entries that match a query with their scores, best first; all of them for a query without words.
	 * @param forgives whether words may have a typo if nothing matches otherwise
	 */
	search(query: string, forgives = true): readonly Scored<T>[] {
		const words = tokensOf(query);
		if (words.length === 0) return this.#entries.map((entry) => ({ entry, score: 0 }));
		const exact = this.#scoresOf(words, false);
		const scores = exact.size > 0 || !forgives ? exact : this.#scoresOf(words, true);
		const [letters, title, phrase] = [lettersOf(query), words.join(" "), phraseOf(words)];
		const whole = (at: number, score: number): number => {
			if (this.#letters[at] === letters) return SAME_LETTERS;
			if (this.#titles[at].join(" ") === title) return SAME_WORDS;
			const shelf = this.#shelves[at].get(phrase);
			if (shelf !== undefined) return SAME_SHELF + shelf;
			return score < LEVEL ? score + this.#titles[at].length * TITLE_WORD : score;
		};
		const found = [...scores].map(([at, score]) => ({ at, score: whole(at, score) + this.#penalties[at] }));
		found.sort((a, b) => a.score - b.score || a.at - b.at);
		return found.map(({ at, score }) => ({ entry: this.#entries[at], score }));
	}

	/**
	 * Adds the words of a text to the index; of titles and shelves also neighbouring words written as one.
	 * @param at index of the entry
	 */
	#add(at: number, text: string, level: MatchLevel): void {
		const words = tokensOf(text, true);
		const pairs = level === DESCRIPTION ? hyphenated(text) : words.slice(1).map((word, i) => words[i] + word);
		for (const word of [...words, ...pairs]) this.#addWord(at, word, level);
	}

	/**
	 * Adds a word of an entry to the index, at the lowest level at which the entry has it.
	 * @param at index of the entry
	 */
	#addWord(at: number, word: string, level: MatchLevel): void {
		const indexed = this.#words.get(word) ?? { word, singular: singularOf(word), levels: new Map() };
		this.#words.set(word, indexed);
		indexed.levels.set(at, Math.min(level, indexed.levels.get(at) ?? level) as MatchLevel);
	}

	/**
	 * Returns the scores of the entries that match every part of a query.
	 * @param forgiving whether words may have a typo
	 */
	#scoresOf(words: readonly string[], forgiving: boolean): Scores {
		const parts = this.#partsOf(words, forgiving);
		const isNeeded = parts.some(({ optional }) => !optional);
		let scores: Map<number, number> | undefined;
		for (const { alternatives } of parts.filter(({ optional }) => !optional || !isNeeded)) {
			const own = this.#scoresOfPart(alternatives, forgiving);
			scores = scores === undefined ? new Map(own) : joinScores(scores, own);
		}
		if (!scores) return new Map();
		for (const { alternatives } of parts.filter(({ optional }) => optional && isNeeded)) {
			for (const [at, score] of this.#scoresOfPart(alternatives, false)) {
				const before = scores.get(at);
				if (before !== undefined && score < LEVEL) scores.set(at, before - OPTIONAL_WORD);
			}
		}
		return scores;
	}

	/** Returns the scores of the entries that match one of the alternatives: each the score of its best one. */
	#scoresOfPart(alternatives: readonly Alternative[], forgiving: boolean): Scores {
		const best = new Map<number, number>();
		for (const { words, synonym = false, cost } of alternatives) {
			let scores: Scores | undefined;
			for (const word of words) {
				const own = this.#scoresOfWord(word, synonym ? "synonym" : forgiving ? "forgiving" : "typed");
				scores = scores === undefined ? own : joinScores(scores, own, Math.max);
			}
			for (const [at, score] of scores ?? []) best.set(at, Math.min(best.get(at) ?? Infinity, score + cost));
		}
		return best;
	}

	/**
	 * Returns the scores of the entries with a word.
	 * @param way synonyms are whole words of titles and shelves
	 */
	#scoresOfWord(word: string, way: "typed" | "forgiving" | "synonym"): Scores {
		const best = new Map<number, number>();
		const singular = singularOf(word);
		for (const indexed of this.#words.values()) {
			const cost = costOf(word, singular, indexed, way);
			if (cost === undefined) continue;
			for (const [at, level] of indexed.levels) {
				if (level === DESCRIPTION && (way === "synonym" || cost === COST.middle)) continue;
				best.set(at, Math.min(best.get(at) ?? Infinity, level * LEVEL + cost));
			}
		}
		return best;
	}

	/** Splits a query into phrases that have synonyms or are written as one word elsewhere, and single words. */
	#partsOf(words: readonly string[], forgiving: boolean): readonly Part[] {
		const parts: Part[] = [];
		for (let at = 0; at < words.length; ) {
			const length = this.#lengthOfPhrase(words, at, forgiving);
			const phrase = words.slice(at, at + length);
			const synonyms = this.#synonymsOf(phrase, forgiving);
			const figure = figureOf(phrase);
			parts.push({
				optional: length === 1 && synonyms.length === 0 && OPTIONAL.has(phrase[0]),
				alternatives: [
					{ words: phrase, cost: 0 },
					...(length > 1 ? [{ words: [phrase.join("")], cost: 0 }] : []),
					...(figure === undefined ? [] : [{ words: [figure], cost: 0 }]),
					...synonyms.map((other, i) => ({
						words: other.includes(":") ? [other] : tokensOf(other),
						synonym: true,
						cost: COST.synonym + i / (10 * synonyms.length),
					})),
				],
			});
			at += length;
		}
		return parts;
	}

	/**
	 * Returns the number of words of the longest phrase at a position that the synonyms or the index know as one, or a
	 * figure.
	 */
	#lengthOfPhrase(words: readonly string[], at: number, forgiving: boolean): number {
		for (let length = Math.min(LONGEST_PHRASE, words.length - at); length > 1; length--) {
			const phrase = words.slice(at, at + length);
			const isWord = this.#words.has(phrase.join("")) && !phrase.some((word) => OPTIONAL.has(word));
			if (isWord || this.#words.has(figureOf(phrase) ?? "") || this.#synonymsOf(phrase, forgiving).length > 0)
				return length;
		}
		return 1;
	}

	/** Returns the synonyms of a phrase; a forgiving search also takes its beginning and one typo. */
	#synonymsOf(words: readonly string[], forgiving: boolean): readonly string[] {
		const phrase = phraseOf(words);
		const known = this.#synonyms.get(phrase);
		if (known || !forgiving || phrase.length < LEAST_FOR_TYPO) return known ?? [];
		for (const [key, others] of this.#synonyms) {
			if (key.startsWith(phrase) || isOneTypo(key, phrase)) return others;
		}
		return [];
	}
}

/** Returns the figure that a number alone, or with a letter, may mean: "15 a"; undefined for other words. */
const figureOf = (words: readonly string[]): string | undefined =>
	/^\d[\d.]*(?: [a-z])?$/.test(words.join(" ")) ? referenceTo("figure", words.join("")) : undefined;

/** Returns the cost of a word of the index for a typed word; undefined where it does not match. */
function costOf(
	word: string,
	singular: string,
	indexed: IndexedWord,
	way: "typed" | "forgiving" | "synonym",
): number | undefined {
	if (indexed.word === word) return 0;
	if (isExact(word) || isExact(indexed.word)) return undefined;
	if (/^\d/.test(word)) return way === "forgiving" && indexed.word.startsWith(word) ? COST.beginning : undefined;
	if (indexed.singular === singular) return COST.plural;
	if (way === "synonym") return undefined;
	if (indexed.word.startsWith(word) || (word.length >= LEAST_FOR_TYPO && indexed.word.startsWith(singular)))
		return COST.beginning;
	if (word.length >= LEAST_FOR_MIDDLE && indexed.word.includes(singular)) return COST.middle;
	if (way === "typed" || word.length < LEAST_FOR_TYPO) return undefined;
	return hasTypo(word, singular, indexed) ? COST.typo : undefined;
}

/** Returns whether a typed word is a word of the index, or its beginning, with one typo. */
function hasTypo(word: string, singular: string, indexed: IndexedWord): boolean {
	if (isOneTypo(word, indexed.word) || isOneTypo(singular, indexed.singular)) return true;
	const { length } = word;
	return (
		length > LEAST_FOR_TYPO &&
		[length - 1, length, length + 1].some((end) => isOneTypo(word, indexed.word.slice(0, end)))
	);
}

/** Joins the scores of two words: only the entries with both. */
function joinScores(a: Scores, b: Scores, join = (one: number, other: number) => one + other): Map<number, number> {
	const both = new Map<number, number>();
	for (const [at, score] of a) {
		const other = b.get(at);
		if (other !== undefined) both.set(at, join(score, other));
	}
	return both;
}

/** Returns the key of a phrase in the table of synonyms: its words in the singular. */
const phraseOf = (words: readonly string[]): string => words.map(singularOf).join(" ");

/** Returns a title letter by letter, with the signs that its words leave out: "table 1, σ*". */
const lettersOf = (text: string): string => text.normalize("NFC").trim().toLowerCase().replace(/\s+/g, " ");

/** Returns the words with a hyphen, written as one: "lsystem". */
const hyphenated = (text: string): readonly string[] =>
	plain(text)
		.split(/[^\p{L}-]+/u)
		.filter((word) => word.includes("-"))
		.map((word) => word.replaceAll("-", ""))
		.filter((word) => word !== "");
