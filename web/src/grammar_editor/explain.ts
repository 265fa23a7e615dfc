/** Explains words of a grammar's text: for the tooltip, and for the hint at the cursor. */

import { text } from "./messages.generated";
import type { GrammarOutline } from "./outline";
import type { Token } from "./scan";
import type { Word } from "./words.generated";

/** Explanation of a word. */
export interface Explanation {
	/** Range in the text. */
	readonly from: number;
	readonly to: number;
	/** As it is written: `F(s)`. */
	readonly written: string;
	readonly help: string;
}

/** Explains the word at a position; undefined if nothing is known about it. */
export function explain(outline: GrammarOutline, place: number, words: readonly Word[]): Explanation | undefined {
	// Between two tokens, the one after the position has priority if it has an explanation.
	for (const piece of outline.pieces.filter(({ from, to }) => from <= place && place <= to).reverse()) {
		const explanation = helpAt(outline, piece, place, words);
		if (explanation) return { from: piece.from, to: piece.to, ...explanation };
	}
	return undefined;
}

/**
 * Returns the help on a word at a place: a constant's own description, a parameter, or the language's; undefined if
 * nothing is known about it.
 */
function helpAt(
	{ pieces, names, symbols }: GrammarOutline,
	piece: Token,
	place: number,
	words: readonly Word[],
): Pick<Explanation, "written" | "help"> | undefined {
	const { kind, text: name } = piece;
	const defined = names.get(name);
	if (defined && (kind === "name" || kind === "function")) return { written: name, help: defined.replace(/\s+/g, " ") };
	if (kind === "name" && formalsAt(pieces, place).includes(name)) {
		return { written: name, help: text("own_parameter") };
	}
	const word = findWord(piece, words);
	if (word)
		return {
			written: word.written,
			help: word.title ? text("described", { title: capital(word.title), help: word.help }) : word.help,
		};
	const symbolForm = kind === "symbol" ? symbols.get(name) : undefined;
	return symbolForm ? { written: symbolForm, help: text("own_symbol") } : undefined;
}

/**
 * Returns the parameter names of the production at a position: names in parentheses before the condition and the arrow,
 * so those of its predecessor and contexts.
 */
export function formalsAt(pieces: readonly Token[], place: number): string[] {
	const arrow = arrowBefore(pieces, place);
	if (arrow === undefined) return [];
	const { line } = pieces[arrow];
	const formals = new Set<string>();
	let depth = 0;
	for (const piece of pieces.slice(0, arrow)) {
		if (piece.line !== line) continue;
		if (piece.text === "(") depth++;
		else if (piece.text === ")") depth--;
		else if (piece.text === ":" && depth === 0) break;
		else if (depth > 0 && piece.kind === "name") formals.add(piece.text);
	}
	return [...formals];
}

/** Returns the line of the production at a position; undefined if there is none, or only a comment. */
export function productionAt(pieces: readonly Token[], place: number, line: number): number | undefined {
	if (!pieces.some((piece) => piece.line === line && piece.kind !== "comment")) return undefined;
	const arrow = arrowBefore(pieces, place);
	return arrow === undefined ? undefined : pieces[arrow].line;
}

/**
 * Returns the index of the arrow of the production at a position; undefined if there is none. A statement ends a
 * production; a line without an arrow continues it.
 */
function arrowBefore(pieces: readonly Token[], place: number): number | undefined {
	let [arrow, first]: (number | undefined)[] = [undefined, undefined];
	for (const [index, { kind, line, from }] of pieces.entries()) {
		if (line !== pieces[index - 1]?.line) first = from;
		if (first === undefined || first > place) break;
		if (kind === "arrow") arrow = index;
		if (kind === "statement") arrow = undefined;
	}
	return arrow;
}

/** Returns the language's word for a token; undefined if the text itself defines it. */
function findWord({ kind, text }: Token, words: readonly Word[]): Word | undefined {
	const byName = (wanted: Word["kind"], name: string) =>
		words.find((word) => word.kind === wanted && word.name === name);
	if (kind === "arrow") return byName("statement", "-->");
	if (kind === "branch") return byName("symbol", text);
	// A function's name may occur without a call.
	if (kind === "name") return byName("function", text);
	return byName(kind as Word["kind"], text.replace(/\s+/g, " ").replace(/ :$/, ":"));
}

/** Returns the words with a capital first letter. */
function capital(words: string): string {
	return words.charAt(0).toUpperCase() + words.slice(1);
}
