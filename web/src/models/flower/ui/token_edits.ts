/**
 * Finds the numbers in a flower's text that define one volume, with their positions, so that sliders can edit them.
 */
import { type NumberRange, outlineOf } from "../../../grammar_editor/outline";
import type { Token } from "../../../grammar_editor/scan";
import { canGrowOnFace } from "./faces";
import { scan } from "./language";
import { overridden } from "./overridden";
import { bare, entriesOf, type FlowerEntry, formsOf, inFields, statementsOf } from "./statements";

/** A number in the text. */
export interface NumberToken {
	/** Name: H, atx, or a variable's. */
	readonly name: string;
	/** Position in the text; includes a preceding minus. */
	readonly from: number;
	readonly to: number;
	readonly text: string;
	/** Range of a constant's slider. */
	readonly range?: NumberRange;
}

/** Numbers that stand together, under a title. */
export interface NumberGroup {
	readonly title: string;
	readonly tokens: readonly NumberToken[];
}

/** Where a volume comes from in the text. */
export interface VolumeOrigin {
	readonly label: string;
	/** Module of the volume, numbered as in the text; 0 is the text outside modules. */
	readonly module: number;
	/** Lines of the production that grows it and of its module's call; 0 for none. */
	readonly line: number;
	readonly call: number;
	/** Faces, if known, that the volume and its module's first volume stand on: 0 O, 1 E, from 2 on C1 … */
	readonly face?: number | undefined;
	readonly foot?: number | undefined;
}

const FIELDS = ["N", "T", "atx", "aty", "atz", "H", "L", "W", "m"];

type Pieces = readonly Token[];

/**
 * Returns the numbers of a volume's definition, its production, its module's call, its module's variables, and the
 * text's variables in that call; no empty groups. Excludes variables that every call sets and numbers that every
 * production overrides, since editing those has no effect. If one line grows the same name several times, returns
 * every list that fits the volume's face, numbered.
 */
export function numberGroupsOf(text: string, { label, module, line, call, face, foot }: VolumeOrigin): NumberGroup[] {
	const scanned = scan(text);
	const pieces = bare(scanned);
	const ranges = new Map(outlineOf(text, scanned).constants.map(({ number, ...range }) => [number.from, range]));
	const forms = formsOf(statementsOf(pieces));
	const modules: { name: string; at: number }[] = [{ name: "", at: 0 }];
	for (const [i, { text: word }] of pieces.entries())
		if (word === "#module" && pieces[i + 1]) modules.push({ name: pieces[i + 1].text, at: i });
	const own = modules[module] ?? modules[0];
	const end = modules[module + 1]?.at ?? pieces.length;
	const form = forms.get(`${own.name}:${label}`);
	const listed = (list: List, translated: boolean | undefined) =>
		numberTokensIn(pieces, inFields(list.entries, translated), FIELDS);
	const idle = overridden(statementsOf(pieces.slice(own.at, end)), label, form);
	const grown = standing(pieces, listsAt(pieces, line, "[", label), face);
	const called = standing(pieces, listsAt(pieces, call, "&", own.name), foot);
	const set = module === 0 ? new Set<string>() : setByEveryCall(pieces, own.name);
	const from = new Set(called.flatMap((each) => wordsFrom(pieces, each.from)));
	return [
		{
			title: `Every ${label}`,
			tokens: definitionsOf(pieces, own.at, end, label)
				.flatMap((each) => listed(each, form))
				.filter(({ name }) => !idle.has(FIELDS.indexOf(name))),
		},
		...grown.map((each, i) => ({
			title: `Where it grows, line ${line}${nth(i, grown)}`,
			tokens: listed(each, form),
		})),
		...called.map((each, i) => ({
			title: `${own.name} as it is called, line ${call}${nth(i, called)}`,
			tokens: [...listed(each, forms.get(`${own.name}:`)), ...settings(pieces, each.end)],
		})),
		{
			title: module === 0 ? "The whole flower" : `Every ${own.name}`,
			tokens: variablesOf(pieces, own.at, end).filter(({ name }) => !set.has(name)),
		},
		{
			title: "The whole flower",
			tokens: module === 0 ? [] : variablesOf(pieces, 0, modules[1]?.at ?? 0).filter(({ name }) => from.has(name)),
		},
	]
		.filter(({ tokens }) => tokens.length > 0)
		.map(({ title, tokens }) => ({
			title,
			tokens: tokens.map((each) => ({ ...each, range: ranges.get(each.from) })),
		}));
}

const nth = (i: number, { length }: readonly unknown[]): string => (length > 1 ? `, ${i + 1} of ${length}` : "");

/** The list of numbers behind a volume's name, and the token behind it. */
interface List {
	readonly entries: readonly FlowerEntry[];
	/** Index of the name. */
	readonly from: number;
	readonly end: number;
}

function listBehind(pieces: Pieces, name: number): List {
	if (pieces[name + 1]?.text !== "(") return { entries: [], from: name, end: name + 1 };
	return { ...entriesOf(pieces, name + 1), from: name };
}

/** Returns the lists of a volume's definitions between two tokens. */
function definitionsOf(pieces: Pieces, from: number, to: number, label: string): List[] {
	const found: List[] = [];
	for (let i = from; i < to; i++)
		if (pieces[i].text === "#define" && pieces[i + 1]?.text === label) found.push(listBehind(pieces, i + 1));
	return found;
}

/** Returns the lists of a name on a line behind a sign: `[` for volumes, `&` for modules. */
function listsAt(pieces: Pieces, line: number, sign: string, name: string): List[] {
	return pieces.flatMap((piece, i) =>
		piece.line === line && piece.text === name && pieces[i - 1]?.text === sign ? [listBehind(pieces, i)] : [],
	);
}

/** Returns the lists whose production may grow on a face; all if none may, since the text has changed. */
function standing(pieces: Pieces, lists: readonly List[], face: number | undefined): readonly List[] {
	const found = lists.filter(({ end }) => canGrowOnFace(pieces, end, face));
	return found.length > 0 ? found : lists;
}

/** Returns the variables with plain numbers between two tokens. */
function variablesOf(pieces: Pieces, from: number, to: number): NumberToken[] {
	const found: NumberToken[] = [];
	for (let i = from; i < to; i++)
		if (pieces[i].text === "#define" && pieces[i + 2]?.text === "=")
			found.push(...numberTokensIn(pieces, [[i + 3, statementEnd(pieces, i + 3)]], [pieces[i + 1].text]));
	return found;
}

/** Returns the names that a call uses, without those that it sets. */
function wordsFrom(pieces: Pieces, call: number): string[] {
	let end = call;
	while (end < pieces.length && pieces[end].text !== "]") end++;
	return pieces
		.slice(call + 1, end)
		.filter((_, i) => pieces[call + 2 + i]?.text !== "=")
		.map(({ text }) => text);
}

/** Returns the variables of a module that every call sets; none if nothing calls it. */
function setByEveryCall(pieces: Pieces, name: string): Set<string> {
	const calls = pieces.flatMap((piece, i) => (piece.text === name && pieces[i - 1]?.text === "&" ? [i] : []));
	const sets = calls.map((call) => {
		const set = new Set<string>();
		for (let i = call + 1; i < pieces.length && pieces[i].text !== "]"; i++)
			if (pieces[i].text === "=") set.add(pieces[i - 1].text);
		return set;
	});
	return new Set([...(sets[0] ?? [])].filter((each) => sets.every((set) => set.has(each))));
}

/** Returns the numbers in the settings behind a call: `{len=66; width=40}`. */
function settings(pieces: Pieces, from: number): NumberToken[] {
	if (pieces[from]?.text !== "{") return [];
	const found: NumberToken[] = [];
	for (let i = from + 1; i < pieces.length && pieces[i].text !== "}"; i++) {
		if (pieces[i].text !== "=") continue;
		let end = i + 1;
		while (end < pieces.length && pieces[end].text !== ";" && pieces[end].text !== "}") end++;
		found.push(...numberTokensIn(pieces, [[i + 1, end]], [pieces[i - 1].text]));
	}
	return found;
}

function statementEnd(pieces: Pieces, from: number): number {
	let end = from;
	while (end < pieces.length && pieces[end].line === pieces[from].line) end++;
	return end;
}

/** Returns the entries that are a plain number, without expressions. */
function numberTokensIn(
	pieces: Pieces,
	entries: readonly (FlowerEntry | undefined)[],
	names: readonly string[],
): NumberToken[] {
	return entries.flatMap((entry, i) => {
		if (!entry) return [];
		let [first, last] = [entry[0], entry[1] - 1];
		if (pieces[first]?.text === "<" && pieces[last]?.text === ">") [first, last] = [first + 1, last - 1];
		const signed = pieces[first]?.text === "-" ? 1 : 0;
		const number = pieces[first + signed];
		if (first + signed !== last || number?.kind !== "number" || names[i] === undefined) return [];
		const start = signed === 1 ? pieces[first] : number;
		return [{ name: names[i], from: start.from, to: number.to, text: `${signed === 1 ? "-" : ""}${number.text}` }];
	});
}
