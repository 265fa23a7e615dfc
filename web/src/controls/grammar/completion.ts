/** What may stand at the cursor: the turtle's symbols and the text's own, functions, constants, parameters, roles, statements. */
import type { Completion, CompletionContext, CompletionResult, CompletionSource } from "@codemirror/autocomplete";
import { formalsAt } from "./explain";
import { type Outline, outlineOf } from "./outline";
import { WORDS } from "./words.generated";

const WORD = /(?:[#?@][\p{L}]*|[\p{L}_][\p{L}\p{N}_]*)$/u;

/** Completes words of a grammar. @param roles the names that `#role` takes */
export function completion(roles: readonly string[]): CompletionSource {
	return (context) => complete(context, roles);
}

function complete(context: CompletionContext, roles: readonly string[]): CompletionResult | null {
	const { pos, explicit, state } = context;
	const line = state.doc.lineAt(pos);
	const word = WORD.exec(line.text.slice(0, pos - line.from))?.[0] ?? "";
	if (word === "" && !explicit) return null;
	const text = state.doc.toString();
	const options = optionsFor(text, pos, word, roles);
	return options.length > 0 ? { from: pos - word.length, options, validFor: /^[#?@]?[\p{L}\p{N}_]*$/u } : null;
}

/** What may stand at a place. @param word what of it stands there already */
export function optionsFor(text: string, place: number, word: string, roles: readonly string[]): Completion[] {
	const from = place - word.length;
	const start = text.lastIndexOf("\n", from - 1) + 1;
	const before = text.slice(start, from);
	if (/^\s*#role\s+$/.test(before)) return roles.map((label) => ({ label, type: "keyword" }));
	// As if a name stood there: so it is told whether modules are meant, or values.
	const outline = outlineOf(`${text.slice(0, from)}x${text.slice(place)}`);
	const kind = outline.pieces.find((piece) => piece.from === from)?.kind;
	if (kind === undefined || kind === "comment") return [];
	const statements = /^\s*$/.test(before) ? ofKind("statement") : [];
	if (kind === "name" || kind === "function") return [...statements, ...values(outline, from)];
	return [...statements, ...modules(outline)];
}

function values(outline: Outline, place: number): Completion[] {
	const formals = formalsAt(outline.pieces, place).filter((name) => name !== "x");
	return [
		...formals.map((label) => ({ label, detail: "parameter", boost: 2 })),
		...[...outline.names].map(([label, info]) => ({ label, detail: info.split(/\s/)[0], info, boost: 1 })),
		...ofKind("function"),
	];
}

function modules({ symbols }: Outline): Completion[] {
	const own = [...symbols].filter(([name]) => name !== "x" && !WORDS.some((word) => word.name === name));
	return [
		...own.map(([label, written]) => ({ label, detail: written === label ? "" : written, boost: 1 })),
		...ofKind("symbol"),
	];
}

/** Words of the table that begin as names do: signs are typed sooner than chosen. */
function ofKind(kind: (typeof WORDS)[number]["kind"]): Completion[] {
	return WORDS.filter((word) => word.kind === kind && /^[\p{L}#?@]/u.test(word.name)).map((word) => ({
		label: word.name,
		detail: kind === "symbol" ? word.title : kind === "function" ? word.written.slice(word.name.length) : "",
		info: word.help,
	}));
}
