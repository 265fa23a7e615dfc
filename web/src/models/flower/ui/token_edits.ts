/**
 * Finds the numbers in a flower's text that define one volume, with their positions, so that sliders can edit them.
 */

import { type NumberRange, outlineOf } from "../../../grammar_editor/outline";
import type { Token } from "../../../grammar_editor/scan";
import { text as message } from "../messages.generated";
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
	readonly moduleFace?: number | undefined;
}

const FIELDS = ["N", "T", "atx", "aty", "atz", "H", "L", "W", "m"];

type Pieces = readonly Token[];

/**
 * Returns the numbers of a volume's definition, its production, its module's call, its module's variables, and the
 * text's variables in that call; no empty groups. Excludes variables that every call sets and numbers that every
 * production overrides, since editing those has no effect. If one line grows the same name several times, returns
 * every list that fits the volume's face, numbered.
 */
export function numberGroupsOf(text: string, origin: VolumeOrigin): NumberGroup[] {
	const scanned = scan(text);
	const pieces = bare(scanned);
	const ranges = new Map(outlineOf(text, scanned).constants.map(({ number, ...range }) => [number.from, range]));
	const grammar = { pieces, forms: formsOf(statementsOf(pieces)), modules: modulesOf(pieces) };
	const own = ownModule(grammar, origin);
	const calls = listsOnFace(pieces, listsAt(pieces, origin.call, "&", own.name), origin.moduleFace);
	return [
		groupOfDefinitions(grammar, own, origin.label),
		...groupsOfProduction(grammar, own, origin),
		...groupsOfCalls(grammar, own, calls, origin.call),
		groupOfModuleVariables(grammar, own, origin.module),
		groupOfCallVariables(grammar, calls, origin.module),
	]
		.filter(({ tokens }) => tokens.length > 0)
		.map(({ title, tokens }) => ({
			title,
			tokens: tokens.map((each) => ({ ...each, range: ranges.get(each.from) })),
		}));
}

/**
 * A module's name and the tokens that it extends over; the first module is the text outside modules, without a name.
 */
interface ModuleSpan {
	readonly name: string;
	readonly from: number;
	readonly to: number;
}

interface FlowerGrammar {
	readonly pieces: Pieces;
	/** Whether lists have a translation (statements.ts). */
	readonly forms: ReadonlyMap<string, boolean>;
	/** Where each module begins; the first is the text outside modules. */
	readonly modules: readonly { readonly name: string; readonly at: number }[];
}

/** Returns the names of the modules and the token at which each begins; the first is the text outside modules. */
function modulesOf(pieces: Pieces): FlowerGrammar["modules"] {
	const modules = [{ name: "", at: 0 }];
	for (const [i, { text: word }] of pieces.entries())
		if (word === "#module" && pieces[i + 1]) modules.push({ name: pieces[i + 1].text, at: i });
	return modules;
}

/** Returns the module of a volume; the text outside modules where the text has changed and lacks it. */
function ownModule({ pieces, modules }: FlowerGrammar, { module }: VolumeOrigin): ModuleSpan {
	const { name, at } = modules[module] ?? modules[0];
	const end = modules[module + 1]?.at ?? pieces.length;
	return { name, from: at, to: end };
}

/** Returns the numbers of a volume's definitions, without those that every production overrides. */
function groupOfDefinitions({ pieces, forms }: FlowerGrammar, own: ModuleSpan, label: string): NumberGroup {
	const form = forms.get(`${own.name}:${label}`);
	const overriddenFields = overridden(statementsOf(pieces.slice(own.from, own.to)), label, form);
	return {
		title: message("group_every", { name: label }),
		tokens: definitionsOf(pieces, own.from, own.to, label)
			.flatMap((list) => fieldsOf(pieces, list, form))
			.filter(({ name }) => !overriddenFields.has(FIELDS.indexOf(name))),
	};
}

/** Returns the numbers of the production that grows the volume: a group for each list that fits the volume's face. */
function groupsOfProduction(
	{ pieces, forms }: FlowerGrammar,
	own: ModuleSpan,
	{ label, line, face }: VolumeOrigin,
): NumberGroup[] {
	const lists = listsOnFace(pieces, listsAt(pieces, line, "[", label), face);
	return lists.map((list, i) => ({
		title:
			lists.length > 1
				? message("group_grows_nth", { line: String(line), number: i + 1, count: lists.length })
				: message("group_grows", { line: String(line) }),
		tokens: fieldsOf(pieces, list, forms.get(`${own.name}:${label}`)),
	}));
}

/** Returns the numbers and settings of the calls of the volume's module in one line: a group for each. */
function groupsOfCalls(
	{ pieces, forms }: FlowerGrammar,
	own: ModuleSpan,
	calls: readonly List[],
	line: number,
): NumberGroup[] {
	return calls.map((list, i) => ({
		title:
			calls.length > 1
				? message("group_called_nth", { name: own.name, line: String(line), number: i + 1, count: calls.length })
				: message("group_called", { name: own.name, line: String(line) }),
		tokens: [...fieldsOf(pieces, list, forms.get(`${own.name}:`)), ...settings(pieces, list.end)],
	}));
}

/** Returns the variables of the volume's module, without those that every call sets. */
function groupOfModuleVariables({ pieces }: FlowerGrammar, own: ModuleSpan, module: number): NumberGroup {
	const setByCalls = module === 0 ? new Set<string>() : setByEveryCall(pieces, own.name);
	return {
		title: module === 0 ? message("group_flower") : message("group_every", { name: own.name }),
		tokens: variablesOf(pieces, own.from, own.to).filter(({ name }) => !setByCalls.has(name)),
	};
}

/**
 * Returns the variables outside modules that the calls of the volume's module use; none for a volume outside modules.
 */
function groupOfCallVariables({ pieces, modules }: FlowerGrammar, calls: readonly List[], module: number): NumberGroup {
	const usedInCalls = new Set(calls.flatMap((call) => namesUsedInCall(pieces, call.from)));
	return {
		title: message("group_flower"),
		tokens: module === 0 ? [] : variablesOf(pieces, 0, modules[1]?.at ?? 0).filter(({ name }) => usedInCalls.has(name)),
	};
}

/** Returns the plain numbers of a list, by the names of FIELDS. */
function fieldsOf(pieces: Pieces, list: List, translated: boolean | undefined): NumberToken[] {
	return numberTokensIn(pieces, inFields(list.entries, translated), FIELDS);
}

/** The list of numbers behind a volume's name, and the token behind it. */
interface List {
	readonly entries: readonly FlowerEntry[];
	/** Index of the name. */
	readonly from: number;
	readonly end: number;
}

/**
 * Returns the list of numbers behind a volume's name; without entries if there is none.
 * @param name index of the name's token
 */
function listBehind(pieces: Pieces, name: number): List {
	if (pieces[name + 1]?.text !== "(") return { entries: [], from: name, end: name + 1 };
	return { ...entriesOf(pieces, name + 1), from: name };
}

/**
 * Returns the lists of a volume's definitions between two tokens.
 * @param from index of the first token
 * @param to index behind the last one
 */
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
function listsOnFace(pieces: Pieces, lists: readonly List[], face: number | undefined): readonly List[] {
	const found = lists.filter(({ end }) => canGrowOnFace(pieces, end, face));
	return found.length > 0 ? found : lists;
}

/**
 * Returns the variables with plain numbers between two tokens.
 * @param from index of the first token
 * @param to index behind the last one
 */
function variablesOf(pieces: Pieces, from: number, to: number): NumberToken[] {
	const found: NumberToken[] = [];
	for (let i = from; i < to; i++)
		if (pieces[i].text === "#define" && pieces[i + 2]?.text === "=")
			found.push(...numberTokensIn(pieces, [[i + 3, statementEnd(pieces, i + 3)]], [pieces[i + 1].text]));
	return found;
}

/**
 * Returns the names that a call uses, without those that it sets.
 * @param call index of the called name's token
 */
function namesUsedInCall(pieces: Pieces, call: number): string[] {
	let end = call;
	while (end < pieces.length && pieces[end].text !== "]") end++;
	return pieces
		.slice(call + 1, end)
		.filter((_, i) => pieces[call + 2 + i]?.text !== "=")
		.map(({ text }) => text);
}

/**
 * Returns the variables of a module that every call sets; none if nothing calls it.
 * @param name of the module
 */
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

/**
 * Returns the numbers in the settings behind a call: `{len=66; width=40}`.
 * @param from index of the token behind the call
 */
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

/**
 * Returns the index of the token behind a statement's line.
 * @param from index of any token of the line
 */
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
