/**
 * Completions at the cursor: symbols of the turtle and of the text, functions, constants, parameters, roles and
 * statements.
 */
import type { Completion, CompletionContext, CompletionResult, CompletionSource } from "@codemirror/autocomplete";
import { type Dialect, dialect } from "./dialect";
import { formalsAt } from "./explain";
import { text } from "./messages.generated";
import { type GrammarOutline, outlineOf } from "./outline";
import { readOutline } from "./read_outline";
import type { Word } from "./words.generated";

/** Tokens of a line: words, and single characters outside words. */
const WORD = /[#?@]\p{L}*|[\p{L}_][\p{L}\p{N}_]*|[\s\S]/gu;
/** Longest word that is completed, in characters. */
const LONGEST_WORD = 250;

/** Completes words of a grammar. @param roles the names that `#role` takes */
export function completion(roles: readonly string[]): CompletionSource {
	return (context) => complete(context, roles);
}

/**
 * Completes the word before the cursor. Without such a word, completions are listed only on request (Ctrl+Space).
 * @param roles words that the model allows as roles
 */
function complete(context: CompletionContext, roles: readonly string[]): CompletionResult | null {
	const { pos, explicit, state } = context;
	const line = state.doc.lineAt(pos);
	const [last = ""] =
		line.text
			.slice(Math.max(0, pos - line.from - LONGEST_WORD), pos - line.from)
			.match(WORD)
			?.slice(-1) ?? [];
	const word = /^[#?@\p{L}_]/u.test(last) ? last : "";
	if (word === "" && !explicit) return null;
	const options = optionsFor(state.doc.toString(), pos, word, roles, state.facet(dialect));
	return options.length > 0 ? { from: pos - word.length, options, validFor: /^[#?@]?[\p{L}\p{N}_]*$/u } : null;
}

/**
 * Returns the completions for a position: roles after `#role`, none in comments, values where the text expects a
 * number, else modules; statements too where the line begins.
 * @param word the part of the word that is already typed
 */
export function optionsFor(
	grammar: string,
	place: number,
	word: string,
	roles: readonly string[],
	language: Dialect,
): Completion[] {
	const from = place - word.length;
	const start = grammar.lastIndexOf("\n", from - 1) + 1;
	const before = grammar.slice(start, from);
	if (/^\s*#role\s+$/.test(before)) return roles.map((label) => ({ label, type: "keyword" }));
	const { words } = language;
	const { outline, name } = isName(word)
		? { outline: readOutline(grammar, language), name: word }
		: withPlaceholder(grammar, from, place, language);
	const kind = outline.pieces.find((piece) => piece.from === from)?.kind;
	if (kind === undefined || kind === "comment") return [];
	// A name that occurs only once is the one being typed.
	const typed = outline.pieces.filter((piece) => piece.text === name).length < 2 ? name : undefined;
	const statements = /^\s*$/.test(before) ? wordsOfKind(words, "statement") : [];
	if (kind === "name" || kind === "function") return [...statements, ...valueCompletions(outline, from, typed, words)];
	return [...statements, ...moduleCompletions(outline, typed, words)];
}

/** Returns whether a word begins as a name does: with a letter or an underscore. */
const isName = (word: string): boolean => /^[\p{L}_]/u.test(word);

/**
 * Returns the outline with the name `x` in place of a range: the kind of that piece shows whether modules or values are
 * expected there.
 * @param from start of the replaced range in the text
 * @param to its end
 */
function withPlaceholder(
	grammar: string,
	from: number,
	to: number,
	{ scan }: Dialect,
): { outline: GrammarOutline; name: string } {
	const name = "x";
	const probe = `${grammar.slice(0, from)}${name}${grammar.slice(to)}`;
	return { outline: outlineOf(probe, scan(probe)), name };
}

/**
 * Returns the completions of an expression: parameters of the production at `place`, names that the text defines, and
 * functions.
 * @param place position in the text
 * @param typed the unfinished word at the cursor, which is no name yet
 */
function valueCompletions(
	outline: GrammarOutline,
	place: number,
	typed: string | undefined,
	words: readonly Word[],
): Completion[] {
	const formals = formalsAt(outline.pieces, place).filter((name) => name !== typed);
	const names = [...outline.names].filter(([name]) => name !== typed);
	return [
		...formals.map((label) => ({ label, detail: text("parameter"), boost: 2 })),
		...names.map(([label, info]) => ({ label, detail: info.split(/\s/)[0], info, boost: 1 })),
		...wordsOfKind(words, "function"),
	];
}

/**
 * Returns the completions of a string of modules: symbols of the text, then those of the turtle.
 * @param typed the unfinished word at the cursor, which is no symbol yet
 */
function moduleCompletions(
	{ symbols }: GrammarOutline,
	typed: string | undefined,
	words: readonly Word[],
): Completion[] {
	const own = [...symbols].filter(([name]) => name !== typed && !words.some((word) => word.name === name));
	return [
		...own.map(([label, written]) => ({ label, detail: written === label ? "" : written, boost: 1 })),
		...wordsOfKind(words, "symbol"),
	];
}

/**
 * Returns the completions of a kind whose names begin with a letter, `#`, `?` or `@`: signs are faster to type than to
 * choose.
 */
function wordsOfKind(words: readonly Word[], kind: Word["kind"]): Completion[] {
	return words
		.filter((word) => word.kind === kind && /^[\p{L}#?@]/u.test(word.name))
		.map((word) => ({
			label: word.name,
			detail: kind === "symbol" ? word.title : kind === "function" ? word.written.slice(word.name.length) : "",
			info: word.help,
		}));
}
