/** What a flower's text says of one volume in figures: where each stands, so that a hand can change it. */
import { scan } from "./language";

/** A figure of the text. */
export interface Figure {
	/** What it says: H, atx, or a variable's name. */
	readonly name: string;
	/** Where it stands; a minus before it is part of it. */
	readonly from: number;
	readonly to: number;
	readonly text: string;
}

/** Figures that stand together. */
export interface Said {
	readonly title: string;
	readonly figures: readonly Figure[];
}

/** Where a volume comes from. */
export interface Asked {
	readonly label: string;
	/** The module that it is of, counted as they stand in the text; 0 the text itself. */
	readonly module: number;
	/** The lines where it is grown and where its module is called; 0 for none. */
	readonly line: number;
	readonly call: number;
}

const PLAIN = ["N", "atx", "aty", "atz", "H", "L", "W", "m"];
const TRANSLATED = ["N", "T", "atx", "aty", "atz", "H", "L", "W", "m"];

type Pieces = ReturnType<typeof scan>;

/**
 * The figures of a volume's definition, of where it is grown, of its module's call, of its module's variables and of those of the text that
 * the call is worked out from; no empty lists. Variables that every call sets are left out: what the module itself says of them holds nowhere.
 */
export function saidOf(text: string, { label, module, line, call }: Asked): Said[] {
	const pieces = scan(text).filter(({ kind }) => kind !== "comment");
	const modules: { name: string; at: number }[] = [{ name: "", at: 0 }];
	for (const [i, { text: word }] of pieces.entries())
		if (word === "#module" && pieces[i + 1]) modules.push({ name: pieces[i + 1].text, at: i });
	const own = modules[module] ?? modules[0];
	const end = modules[module + 1]?.at ?? pieces.length;
	const definition: Figure[] = [];
	let translated = false;
	for (let i = own.at; i < end; i++) {
		if (pieces[i].text !== "#define") continue;
		const [name, sign] = [pieces[i + 1], pieces[i + 2]];
		if (name?.text === label && sign?.text === "(") {
			const entries = entriesOf(pieces, i + 2);
			translated = entries.length > 8;
			definition.push(...figuresBetween(pieces, entries, translated ? TRANSLATED : PLAIN));
		}
	}
	const fields = (entries: readonly unknown[]) =>
		entries.length === 9 || (entries.length !== 8 && translated) ? TRANSLATED : PLAIN;
	const grown = listAt(pieces, line, label);
	const called = listAt(pieces, call, own.name);
	const set = module === 0 ? new Set<string>() : setByEveryCall(pieces, own.name);
	const from = called ? wordsFrom(pieces, called.from) : new Set<string>();
	return [
		{ title: `Every ${label}`, figures: definition },
		{
			title: `Where it grows, line ${line}`,
			figures: grown ? figuresBetween(pieces, grown.entries, fields(grown.entries)) : [],
		},
		{
			title: `${own.name} as it is called, line ${call}`,
			figures: called
				? [...figuresBetween(pieces, called.entries, fields(called.entries)), ...settings(pieces, called.end)]
				: [],
		},
		{
			title: module === 0 ? "The whole flower" : `Every ${own.name}`,
			figures: variablesOf(pieces, own.at, end).filter(({ name }) => !set.has(name)),
		},
		{
			title: "The whole flower",
			figures: module === 0 ? [] : variablesOf(pieces, 0, modules[1]?.at ?? 0).filter(({ name }) => from.has(name)),
		},
	].filter(({ figures }) => figures.length > 0);
}

/** The list behind a name that grows on a line, and where it ends. */
function listAt(pieces: Pieces, line: number, name: string) {
	const at = pieces.findIndex(
		(piece, i) => piece.line === line && piece.text === name && ["[", "&"].includes(pieces[i - 1]?.text),
	);
	if (at < 0) return undefined;
	if (pieces[at + 1]?.text !== "(") return { entries: [], from: at, end: at + 1 };
	const entries = entriesOf(pieces, at + 1);
	return { entries, from: at, end: (entries.at(-1)?.[1] ?? at + 1) + 1 };
}

/** Variables that are figures, of the statements between two places. */
function variablesOf(pieces: Pieces, from: number, to: number): Figure[] {
	const found: Figure[] = [];
	for (let i = from; i < to; i++)
		if (pieces[i].text === "#define" && pieces[i + 2]?.text === "=")
			found.push(...figuresBetween(pieces, [[i + 3, statementEnd(pieces, i + 3)]], [pieces[i + 1].text]));
	return found;
}

/** What stands between the bracket of a call and its end: names are set before a =, and used elsewhere. */
const wordsFrom = (pieces: Pieces, call: number): Set<string> => {
	let end = call;
	while (end < pieces.length && pieces[end].text !== "]") end++;
	return new Set(
		pieces
			.slice(call + 1, end)
			.filter((_, i) => pieces[call + 2 + i]?.text !== "=")
			.map(({ text }) => text),
	);
};

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
function settings(pieces: Pieces, from: number): Figure[] {
	if (pieces[from]?.text !== "{") return [];
	const found: Figure[] = [];
	for (let i = from + 1; i < pieces.length && pieces[i].text !== "}"; i++) {
		if (pieces[i].text !== "=") continue;
		let end = i + 1;
		while (end < pieces.length && pieces[end].text !== ";" && pieces[end].text !== "}") end++;
		found.push(...figuresBetween(pieces, [[i + 1, end]], [pieces[i - 1].text]));
	}
	return found;
}

/** What stands between the commas of a list whose bracket opens at `open`: first piece and the one behind the last. */
function entriesOf(pieces: Pieces, open: number): [number, number][] {
	const entries: [number, number][] = [];
	let from = open + 1;
	let depth = 0;
	for (let i = open; i < pieces.length; i++) {
		const { text } = pieces[i];
		if (text === "(") depth++;
		if (text === ")") depth--;
		if (depth === 0 || (depth === 1 && text === ",")) {
			entries.push([from, i]);
			from = i + 1;
		}
		if (depth === 0) break;
	}
	return entries;
}

function statementEnd(pieces: Pieces, from: number): number {
	let end = from;
	while (end < pieces.length && pieces[end].line === pieces[from].line) end++;
	return end;
}

/** Those entries that are a figure and nothing else; a number that is worked out is none. */
function figuresBetween(pieces: Pieces, entries: readonly [number, number][], names: readonly string[]): Figure[] {
	return entries.flatMap(([from, to], i) => {
		let [first, last] = [from, to - 1];
		if (pieces[first]?.text === "<" && pieces[last]?.text === ">") [first, last] = [first + 1, last - 1];
		const signed = pieces[first]?.text === "-" ? 1 : 0;
		const number = pieces[first + signed];
		if (first + signed !== last || number?.kind !== "number" || names[i] === undefined) return [];
		const start = signed === 1 ? pieces[first] : number;
		return [{ name: names[i], from: start.from, to: number.to, text: `${signed === 1 ? "-" : ""}${number.text}` }];
	});
}
