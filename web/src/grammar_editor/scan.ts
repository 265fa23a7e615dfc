/** Splits a grammar's text into tokens for colouring and editing. Errors are left to the core. */

/** Kind of a token. */
export type TokenKind =
	| "comment"
	/** Beginning of a statement: `#define`, `axiom:`, `derivation length:`. */
	| "statement"
	| "arrow"
	/** Symbol of a module, of the turtle or of the text. */
	| "symbol"
	/** `[`, `]`. */
	| "branch"
	/** A name in an expression. */
	| "name"
	/** Name in a call. */
	| "function"
	| "number"
	| "operator"
	/** `(`, `)`, `,`, `{`, `}` and all other characters. */
	| "mark";

/** A token with its range in the text; `line` counts from 1. */
export interface Token {
	readonly kind: TokenKind;
	readonly from: number;
	readonly to: number;
	readonly text: string;
	readonly line: number;
}

/** Context of the scanner: modules or expressions. */
type Sort = "modules" | "values";

const PIECE =
	/\/\*[\s\S]*?(?:\*\/|$)|\n|[ \t\r\f\v]+|-->|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[\p{L}_][\p{L}\p{N}_]*|\?\p{L}|@\p{L}*|#\p{L}+|[<>=!]=|&&|\|\||[\s\S]/gu;
/** Beginnings of lines, other than directives, up to the colon. */
const HEAD =
	/^(?:axiom|derivation[ \t]+length|maximum[ \t]+depth|ignore|consider|angle[ \t]+increment|line[ \t]+(?:length|width)(?:[ \t]+increment)?|tropism|Lsystem)[ \t]*:/;
const ALONE = /^(decomposition|homomorphism|derivation|endlsystem)[ \t]*(?:\n|\/\*|$)/;
/** Statements whose line contains values; other lines contain modules. */
const OF_VALUES = /^(?:#define|#input|#curve|derivation|maximum|angle|line|tropism)/;
const VALUE_SIGNS = /^(?:[<>=!]=|&&|\|\||[-+*/%^!<>=])$/;

/** Splits a text into tokens, without blanks. */
export function scan(text: string): Token[] {
	return new Scanner(text).pieces;
}

/** Returns the index of the first token that ends behind a position; the number of tokens if there is none. */
export function firstEndingBehind(pieces: readonly Token[], place: number): number {
	let [low, high] = [0, pieces.length];
	while (low < high) {
		const middle = (low + high) >> 1;
		if (pieces[middle].to > place) high = middle;
		else low = middle + 1;
	}
	return low;
}

class Scanner {
	readonly pieces: Token[] = [];
	readonly #text: string;
	#line = 1;
	#sort: Sort = "modules";
	/** Number of open parentheses. */
	#depth = 0;
	/** Whether the arrow of this line is still to come. */
	#before = false;

	/**
	 * Scans the whole text. The first token of a line that is no comment decides how the rest of it is read (`#startLine`).
	 */
	constructor(text: string) {
		this.#text = text;
		let fresh = true;
		PIECE.lastIndex = 0;
		for (let match = PIECE.exec(text); match; match = PIECE.exec(text)) {
			const [piece] = match;
			if (piece === "\n") {
				this.#line++;
				fresh = true;
				continue;
			}
			if (/^[ \t\r\f\v]/.test(piece)) continue;
			if (piece.startsWith("/*")) {
				this.#add("comment", match.index, piece);
				this.#line += piece.split("\n").length - 1;
				continue;
			}
			if (fresh) {
				fresh = false;
				const head = this.#startLine(match.index);
				if (head > 0) {
					PIECE.lastIndex = match.index + head;
					continue;
				}
			}
			this.#piece(match.index, piece);
		}
	}

	/**
	 * Begins a line: a statement, a production or a continuation.
	 * @param start index of its first token in the text
	 * @returns length of the statement's head, 0 if there is none
	 */
	#startLine(start: number): number {
		const end = this.#text.indexOf("\n", start);
		const line = this.#text.slice(start, end < 0 ? undefined : end);
		const head = /^#\p{L}+/u.exec(line)?.[0] ?? HEAD.exec(line)?.[0] ?? ALONE.exec(line)?.[1];
		this.#before = head === undefined && line.includes("-->");
		if (head === undefined) {
			if (this.#before) this.#enter("modules");
			return 0;
		}
		this.#enter(OF_VALUES.test(head) ? "values" : "modules");
		this.#add("statement", start, head);
		return head.length;
	}

	/** Begins a part of the text that contains modules or values. */
	#enter(sort: Sort): void {
		this.#sort = sort;
		this.#depth = 0;
	}

	/**
	 * Adds a piece of text as a token; arrows and colons decide whether modules or values follow.
	 * @param start index of the piece in the text
	 */
	#piece(start: number, piece: string): void {
		if (piece === "-->") {
			this.#before = false;
			this.#enter("modules");
			this.#add("arrow", start, piece);
			return;
		}
		// After a colon come a condition and a weight; a block before the arrow contains values, too.
		if (this.#depth === 0 && (piece === ":" || (this.#before && piece === "{"))) {
			this.#sort = "values";
			this.#add("mark", start, piece);
			return;
		}
		this.#add(this.#kindOf(start, piece), start, piece);
		if (piece === "(") this.#depth++;
		else if (piece === ")") this.#depth = Math.max(0, this.#depth - 1);
	}

	/**
	 * Classifies a piece by its first characters and by where it is: within parentheses and values are names, functions
	 * and operators; elsewhere symbols of the string.
	 * @param start index of the piece in the text
	 */
	#kindOf(start: number, piece: string): TokenKind {
		const named = /^[\p{L}_]/u.test(piece);
		if (/^[\d.]/.test(piece) && piece !== ".") return "number";
		if (/^[(),.;]$/.test(piece))
			return this.#depth === 0 && piece !== "(" && piece !== ")" ? this.#kindOfSeparator() : "mark";
		if (this.#depth > 0 || this.#sort === "values") {
			// A name after #define is not a call, even before a parenthesis.
			if (named && this.pieces.at(-1)?.text !== "#define")
				return /^[ \t]*\(/.test(this.#text.slice(start + piece.length, start + piece.length + 8)) ? "function" : "name";
			if (named) return "name";
			return VALUE_SIGNS.test(piece) ? "operator" : "mark";
		}
		if (piece === "[" || piece === "]") return "branch";
		if (this.#before && (piece === "<" || piece === ">")) return "operator";
		return named || /^[-+&^/\\|!%$'~{}<>#]$|^[?@]/.test(piece) ? "symbol" : "mark";
	}

	/**
	 * Returns the kind of `,`, `.` and `;` outside parentheses: symbols of the turtle between modules, separators between
	 * values.
	 */
	#kindOfSeparator(): TokenKind {
		return this.#sort === "modules" ? "symbol" : "mark";
	}

	/** Adds a token of the current line. */
	#add(kind: TokenKind, from: number, text: string): void {
		this.pieces.push({ kind, from, to: from + text.length, text, line: this.#line });
	}
}
