/** What a flower's text says of one volume in tokens: where each stands, so that a hand can change it. */
import { outlineOf, type Range } from "../../../grammar_editor/outline";
import type { Piece } from "../../../grammar_editor/scan";
import { canGrowOnFace } from "./faces";
import { scan } from "./language";
import { overridden } from "./overridden";
import { bare, type Entry, entriesOf, formsOf, inFields, statementsOf } from "./statements";

/** A token of the text. */
export interface NumberToken {
	/** What it says: H, atx, or a variable's name. */
	readonly name: string;
	/** Where it stands; a minus before it is part of it. */
	readonly from: number;
	readonly to: number;
	readonly text: string;
	/** Of a constant of the text how far its slider goes. */
	readonly range?: Range;
}

/** Figures that stand together. */
export interface NumberGroup {
	readonly title: string;
	readonly tokens: readonly NumberToken[];
}

/** Where a volume comes from. */
export interface VolumeOrigin {
	readonly label: string;
	/** The module that it is of, counted as they stand in the text; 0 the text itself. */
	readonly module: number;
	/** The lines where it is grown and where its module is called; 0 for none. */
	readonly line: number;
	readonly call: number;
	/** The faces that it stands on, and that what its module's call has grown stands on: 0 O, 1 E, from 2 on C1 …; where they are known. */
	readonly face?: number | undefined;
	readonly foot?: number | undefined;
}

const FIELDS = ["N", "T", "atx", "aty", "atz", "H", "L", "W", "m"];

type Pieces = readonly Piece[];

/**
 * The tokens of a volume's definition, of where it is grown, of its module's call, of its module's variables and of those of the text that
 * the call is worked out from; no empty lists. Variables that every call sets are left out, and of a definition what every growth gives
 * otherwise: what is said of them there holds nowhere.
 * Of several of one name on one line there are all that may have grown on its face, each by its place.
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

/** A list behind a volume's name, and the piece behind it. */
interface List {
	readonly entries: readonly Entry[];
	/** The name. */
	readonly from: number;
	readonly end: number;
}

function listBehind(pieces: Pieces, name: number): List {
	if (pieces[name + 1]?.text !== "(") return { entries: [], from: name, end: name + 1 };
	return { ...entriesOf(pieces, name + 1), from: name };
}

/** The lists of a volume's definition in a module that stands between two places. */
function definitionsOf(pieces: Pieces, from: number, to: number, label: string): List[] {
	const found: List[] = [];
	for (let i = from; i < to; i++)
		if (pieces[i].text === "#define" && pieces[i + 1]?.text === label) found.push(listBehind(pieces, i + 1));
	return found;
}

/** Those of a name that stands on a line behind a sign: `[` where a volume grows, `&` where a module does. */
function listsAt(pieces: Pieces, line: number, sign: string, name: string): List[] {
	return pieces.flatMap((piece, i) =>
		piece.line === line && piece.text === name && pieces[i - 1]?.text === sign ? [listBehind(pieces, i)] : [],
	);
}

/** Those that may stand on a face; all where none may, for then the text has changed. */
function standing(pieces: Pieces, lists: readonly List[], face: number | undefined): readonly List[] {
	const found = lists.filter(({ end }) => canGrowOnFace(pieces, end, face));
	return found.length > 0 ? found : lists;
}

/** Variables that are tokens, of the statements between two places. */
function variablesOf(pieces: Pieces, from: number, to: number): NumberToken[] {
	const found: NumberToken[] = [];
	for (let i = from; i < to; i++)
		if (pieces[i].text === "#define" && pieces[i + 2]?.text === "=")
			found.push(...numberTokensIn(pieces, [[i + 3, statementEnd(pieces, i + 3)]], [pieces[i + 1].text]));
	return found;
}

/** What stands between the bracket of a call and its end: names are set before a =, and used elsewhere. */
function wordsFrom(pieces: Pieces, call: number): string[] {
	let end = call;
	while (end < pieces.length && pieces[end].text !== "]") end++;
	return pieces
		.slice(call + 1, end)
		.filter((_, i) => pieces[call + 2 + i]?.text !== "=")
		.map(({ text }) => text);
}

/** Variables of a module that none of its calls leaves as the module has them; none where nothing calls it. */
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

/** `{len=66; width=40}` behind a call. */
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

/** Those entries that are a token and nothing else; a number that is worked out is none. */
function numberTokensIn(
	pieces: Pieces,
	entries: readonly (Entry | undefined)[],
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
