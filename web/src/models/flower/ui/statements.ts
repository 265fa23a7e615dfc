/** A flower's text as its reader in the core takes it: statements and lists of volumes' numbers (wasm-core/src/models/flower/syntax/reader.cpp). */
import { wordOf } from "../../../grammar_editor/outline";
import type { Piece } from "../../../grammar_editor/scan";

/** Without comments; statements' words stand at their sign, however they are written: `# define` is one #define. */
export function bare(pieces: readonly Piece[]): Piece[] {
	const found: Piece[] = [];
	for (const piece of pieces) {
		if (piece.kind === "comment") continue;
		const before = found.at(-1);
		const parted = before?.text === "#" && before.line === piece.line && /^\p{L}/u.test(piece.text);
		if (before && parted)
			found[found.length - 1] = { ...piece, kind: "statement", from: before.from, text: `#${piece.text}` };
		else found.push(piece.kind === "statement" ? { ...piece, text: wordOf(piece) } : piece);
	}
	return found;
}

/** Within brackets, and where something has to follow, they go on in the next line. @param pieces bare ones */
export function statementsOf(pieces: readonly Piece[]): Piece[][] {
	const statements: Piece[][] = [];
	let depth = 0;
	for (const [i, piece] of pieces.entries()) {
		const before = pieces[i - 1];
		const goesOn =
			piece.kind !== "statement" &&
			(depth > 0 ||
				before?.kind === "arrow" ||
				piece.kind === "arrow" ||
				/^[,|<:]$/.test(before?.text ?? "") ||
				/^[[{:|]$/.test(piece.text));
		if (!before || (piece.line > before.line && !goesOn)) {
			statements.push([]);
			depth = 0;
		}
		statements[statements.length - 1].push(piece);
		if (/^[([{]$/.test(piece.text)) depth++;
		if (/^[)\]}]$/.test(piece.text)) depth = Math.max(0, depth - 1);
	}
	return statements;
}

/** Whether a volume's lists have a translation, by `module:volume`; and that of what a module begins with, by `module:`. */
export function formsOf(statements: readonly (readonly Piece[])[]): Map<string, boolean> {
	const forms = new Map<string, boolean>();
	const begun: [module: string, name: string][] = [];
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
			const begins = pieces.find(({ kind }, i) => i > 0 && kind !== "mark" && kind !== "operator");
			if (begins) begun.push([module, begins.text]);
		}
	}
	for (const [of, name] of begun) forms.set(`${of}:`, forms.get(`${of}:${name}`) ?? false);
	return forms;
}

/** Of what stands between two commas the first piece and the one behind the last. */
export type Entry = readonly [from: number, to: number];

/** What stands between the commas of a list whose bracket opens at a piece, and the piece behind it. */
export function entriesOf(pieces: readonly Piece[], open: number): { entries: Entry[]; end: number } {
	const entries: Entry[] = [];
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
 * The entries of a list by what they say: N, T, atx, aty, atz, H, L, W, m; undefined where it has no place for it.
 * @param translated whether its volume's lists have a translation
 */
export function inFields(entries: readonly Entry[], translated: boolean | undefined): (Entry | undefined)[] {
	// Of ten numbers one angle is too many (docs/models/flower/language.md).
	const said = entries.filter((_, i) => entries.length !== 10 || i !== 5);
	const whole = said.length === 9 || (said.length !== 8 && translated);
	return whole ? said : [said[0], undefined, ...said.slice(1)];
}
