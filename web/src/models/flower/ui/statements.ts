/**
 * Splits a flower's text into statements and lists of volumes' numbers, like the core's reader
 * (wasm-core/src/models/flower/syntax/reader.cpp).
 */
import { wordOf } from "../../../grammar_editor/outline";
import type { Token } from "../../../grammar_editor/scan";

/** Removes comments and normalises the words of statements: `# define` becomes `#define`. */
export function bare(pieces: readonly Token[]): Token[] {
	const tokens: Token[] = [];
	for (const piece of pieces) {
		if (piece.kind === "comment") continue;
		const before = tokens.at(-1);
		const isSplitWord = before?.text === "#" && before.line === piece.line && /^\p{L}/u.test(piece.text);
		if (before && isSplitWord)
			tokens[tokens.length - 1] = { ...piece, kind: "statement", from: before.from, text: `#${piece.text}` };
		else tokens.push(piece.kind === "statement" ? { ...piece, text: wordOf(piece) } : piece);
	}
	return tokens;
}

/**
 * Splits tokens into statements. A statement continues on the next line inside brackets and where more must follow.
 * @param pieces tokens without comments
 */
export function statementsOf(pieces: readonly Token[]): Token[][] {
	const statements: Token[][] = [];
	let depth = 0;
	for (const [i, piece] of pieces.entries()) {
		const before = pieces[i - 1];
		const continues =
			piece.kind !== "statement" &&
			(depth > 0 ||
				before?.kind === "arrow" ||
				piece.kind === "arrow" ||
				/^[,|<:]$/.test(before?.text ?? "") ||
				/^[[{:|]$/.test(piece.text));
		if (!before || (piece.line > before.line && !continues)) {
			statements.push([]);
			depth = 0;
		}
		statements[statements.length - 1].push(piece);
		if (/^[([{]$/.test(piece.text)) depth++;
		if (/^[)\]}]$/.test(piece.text)) depth = Math.max(0, depth - 1);
	}
	return statements;
}

/**
 * Returns whether each volume's lists have a translation, by `module:volume`, and of each module's axiom by `module:`.
 */
export function formsOf(statements: readonly (readonly Token[])[]): Map<string, boolean> {
	const forms = new Map<string, boolean>();
	const axioms: [module: string, name: string][] = [];
	let module = "";
	for (const pieces of statements) {
		const [head, name, sign, third] = pieces;
		if (head.text === "#module") module = name?.text ?? "";
		if (head.text === "#define" && name && sign?.text !== "=")
			forms.set(
				`${module}:${name.text}`,
				sign?.text === "(" && third !== undefined && entriesOf(pieces, 2).entries.length > 8,
			);
		if (/^#axiome?$/.test(head.text)) {
			const first = pieces.find(({ kind }, i) => i > 0 && kind !== "mark" && kind !== "operator");
			if (first) axioms.push([module, first.text]);
		}
	}
	for (const [axiomModule, name] of axioms) forms.set(`${axiomModule}:`, forms.get(`${axiomModule}:${name}`) ?? false);
	return forms;
}

/** Range of the tokens of an entry: the first token, and the one behind the last. */
export type FlowerEntry = readonly [from: number, to: number];

/** Returns the entries of the list whose bracket opens at a token, and the token behind the list. */
export function entriesOf(pieces: readonly Token[], open: number): { entries: FlowerEntry[]; end: number } {
	const entries: FlowerEntry[] = [];
	let [from, depth] = [open + 1, 0];
	for (let i = open; i < pieces.length; i++) {
		const { text } = pieces[i];
		if (/^[([]$/.test(text)) depth++;
		if (/^[)\]]$/.test(text)) depth--;
		if (depth === 0 || (depth === 1 && text === ",")) {
			entries.push([from, i]);
			from = i + 1;
		}
		if (depth === 0) return { entries, end: i + 1 };
	}
	return { entries, end: pieces.length };
}

/**
 * Assigns a list's entries to N, T, atx, aty, atz, H, L, W, m; undefined for numbers that the list lacks.
 * @param translated whether the volume's lists have a translation
 */
export function inFields(
	entries: readonly FlowerEntry[],
	translated: boolean | undefined,
): (FlowerEntry | undefined)[] {
	// Lists of ten numbers have one angle too many (docs/models/flower/language.md).
	const withoutExtra = entries.filter((_, i) => entries.length !== 10 || i !== 5);
	const hasTranslation = withoutExtra.length === 9 || (withoutExtra.length !== 8 && translated);
	return hasTranslation ? withoutExtra : [withoutExtra[0], undefined, ...withoutExtra.slice(1)];
}
