/**
 * Reads a published grammar's text for the oracle, from the notation's description and independently of the core's
 * parser, so that the two can be compared. Reads deterministic grammars: constants, `ignore:`, `consider:`, contexts,
 * conditions. Homomorphisms are skipped, since they do not change the string.
 */

/** A module as it is written: its symbol and the texts of its arguments. */
export interface Written {
	symbol: string;
	args: string[];
}

export interface Production {
	left: Written[];
	symbol: string;
	formals: string[];
	right: Written[];
	condition: string;
	successor: Written[];
}

export interface Published {
	constants: ReadonlyMap<string, number>;
	steps: number;
	axiom: Written[];
	/** Whether contexts pass over a symbol. */
	ignored: (symbol: string) => boolean;
	productions: Production[];
}

/** Symbols that begin with a sign are one character, but for these. */
const LONG = /^(?:@[A-Za-z]+|~\w+|[\p{L}][\p{L}\d_]*)/u;

/** Splits at top level only: not within parentheses. */
function split(text: string, at: string): string[] {
	const parts = [""];
	let depth = 0;
	for (const character of text) {
		if (character === "(") depth++;
		if (character === ")") depth--;
		if (character === at && depth === 0) parts.push("");
		else parts[parts.length - 1] += character;
	}
	return parts;
}

/** The modules of an axiom, a successor or a context. */
export function modules(text: string): Written[] {
	const found: Written[] = [];
	let rest = text.trim();
	while (rest) {
		const symbol = LONG.exec(rest)?.[0] ?? rest[0];
		rest = rest.slice(symbol.length);
		let args: string[] = [];
		if (rest.startsWith("(")) {
			let depth = 0;
			const end = [...rest].findIndex((c) => (c === "(" ? ++depth : c === ")" ? --depth : 1) === 0);
			args = split(rest.slice(1, end), ",");
			rest = rest.slice(end + 1);
		}
		found.push({ symbol, args });
		rest = rest.trimStart();
	}
	return found;
}

const OPERATIONS: [RegExp, string][] = [
	[/([^<>!=])=([^=])/g, "$1==$2"],
	[/\^/g, "**"],
	[/\b(sqrt|min|max|abs|floor|exp)\b/g, "Math.$1"],
	[/(?<![\w.])\d+\.\d+/g, "Math.fround($&)"],
];

const compiled = new Map<string, (...values: number[]) => number>();

/**
 * Value of an expression on single precision numbers. Intermediate results are in double precision; the comparison's
 * tolerance covers the difference.
 */
export function evaluate(text: string, names: ReadonlyMap<string, number>): number {
	const key = `${[...names.keys()]}:${text}`;
	let run = compiled.get(key);
	if (!run) {
		const script = OPERATIONS.reduce((now, [from, to]) => now.replace(from, to), text);
		run = new Function(...names.keys(), `return Math.fround(${script});`) as (...values: number[]) => number;
		compiled.set(key, run);
	}
	return run(...names.values());
}

function production(line: string): Production {
	const [head, tail] = line.split("-->");
	const [pattern, condition = "1"] = split(head, ":");
	const [, left, own, right] = /^(?:(.*?)<)?([^<>]*)(?:>(.*))?$/.exec(pattern) ?? [];
	const [{ symbol, args }] = modules(own);
	const successor = tail.trim() === "*" ? [] : modules(tail);
	const context = (text = "") => (text.trim() === "*" ? [] : modules(text));
	return { left: context(left), symbol, formals: args, right: context(right), condition, successor };
}

/** @throws when the text has random productions or environment queries, which the oracle does not support */
export function readPublished(text: string): Published {
	const plain = text.replace(/\/\*[\s\S]*?\*\//g, "");
	const [derivation] = plain.split(/^homomorphism$/m);
	if (/\b(ran|nran|RND)\(|\?[A-Z]|-->[^\n]*:/.test(derivation)) throw new Error("not deterministic");
	const constants = new Map<string, number>();
	const published = {
		constants,
		steps: 0,
		axiom: [] as Written[],
		ignored: (_: string) => false,
		productions: [] as Production[],
	};
	for (const line of derivation.split("\n")) {
		const [, word, value] = /^(#define \w+|[a-z ]+:)\s*(.*?)\s*$/.exec(line) ?? [];
		if (line.includes("-->")) published.productions.push(production(line));
		else if (word?.startsWith("#define")) constants.set(word.slice(8), evaluate(value, constants));
		else if (word === "derivation length:") published.steps = evaluate(value, constants);
		else if (word === "axiom:") published.axiom = modules(value);
		else if (word === "ignore:" || word === "consider:") {
			const named = new Set(modules(value).map(({ symbol }) => symbol));
			published.ignored = (symbol) => named.has(symbol) === (word === "ignore:");
		}
	}
	return published;
}
