/** Languages whose text is a list of statements: their scanner, and the words that the editor explains. */
import type { Token, TokenKind } from "./scan";
import type { Word } from "./words.generated";

/** Syntax of such a language. */
export interface StatementSyntax {
	/** Matches any token or blanks, as a literal with the flags "gu": tests check that it does not backtrack. */
	readonly token: RegExp;
	/**
	 * Returns the kind of one of its own tokens; undefined for all others.
	 * @param isFirst whether the token is the first of its line, besides comments
	 * @param isCalled whether an opening parenthesis follows
	 */
	kindOf(token: string, isFirst: boolean, isCalled: boolean): TokenKind | undefined;
}

const OPERATOR = /^(?:[<>=!]=|&&|\|\||[-+*/%^!<>=|])$/;

/** Creates the scanner of a language: it splits a text into tokens, without blanks. */
export function statementScanner({ token: pattern, kindOf }: StatementSyntax): (text: string) => Token[] {
	return (text) => {
		const found: Token[] = [];
		let line = 1;
		let isFirst = true;
		for (const { 0: token, index } of text.matchAll(pattern)) {
			const to = index + token.length;
			if (!/^\s/.test(token)) {
				const isCalled = /^[ \t]*\(/.test(text.slice(to, to + 8));
				const kind = kindOf(token, isFirst, isCalled) ?? sharedKind(token);
				found.push({ kind, from: index, to, text: token, line });
				if (kind !== "comment") isFirst = false;
			}
			if (token === "\n") isFirst = true;
			line += token.split("\n").length - 1;
		}
		return found;
	};
}

/** Returns the kind of a token that all languages share. */
function sharedKind(token: string): TokenKind {
	if (token.startsWith("/*")) return "comment";
	if (/^(?:-->|->|→)$/.test(token)) return "arrow";
	if (/^[\d.]/.test(token) && token !== ".") return "number";
	if (token.startsWith('"')) return "symbol";
	return OPERATOR.test(token) ? "operator" : "mark";
}

/** Whether a token begins with a letter. */
export const isName = (token: string): boolean => /^\p{L}/u.test(token);

/**
 * Describes a statement for completion and help.
 * @param written an example of it
 */
export const statementWord = (name: string, written: string, help: string): Word => ({
	kind: "statement",
	name,
	written,
	help,
});

/**
 * Describes a word inside statements for completion and help.
 * @param written an example of it
 */
export const innerWord = (name: string, help: string, written = name): Word => ({
	kind: "function",
	name,
	written,
	help,
});
