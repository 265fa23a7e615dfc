/** From wasm-core/parameters/turtle.json and language.json: the words that the editor of grammars knows. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder } from "../repository.mjs";

const read = (name) => JSON.parse(readFileSync(join(coreFolder, `parameters/${name}.json`), "utf8"));

/** How a symbol is written with its arguments. */
function written({ symbol, argument, arguments: several }) {
	if (several === "any") return `${symbol}(…)`;
	const inside = several ?? argument;
	return inside ? `${symbol}(${inside})` : symbol;
}

const word = ({ kind, name, text, title, help }) => {
	const fields = Object.entries({ kind, name, written: text, title, help }).filter(([, value]) => value !== undefined);
	return `\t{\n${fields.map(([key, value]) => `\t\t${key}: ${JSON.stringify(value)},`).join("\n")}\n\t},`;
};

/** Returns the generated file. */
export function outputs() {
	const { symbols } = read("turtle");
	const { statements, functions } = read("language");
	const words = [
		...symbols.map((row) => ({
			kind: "symbol",
			name: row.symbol,
			text: written(row),
			title: row.name,
			help: row.help,
		})),
		...statements.map(({ word: name, written: text, help }) => ({ kind: "statement", name, text, help })),
		...functions.map((row) => ({
			kind: "function",
			name: row.name,
			text: `${row.name}(${row.arguments})`,
			help: row.help,
		})),
	];
	return [
		{
			path: "web/src/grammar_editor/words.generated.ts",
			text: `// Made from wasm-core/parameters/turtle.json and language.json by wasm-core/tools/generate.mjs; edit the tables, not this.

/** Words of the notation of grammars: the turtle's symbols, keywords that begin a statement, and functions. */
export interface Word {
	readonly kind: "symbol" | "statement" | "function";
	readonly name: string;
	/** With its arguments. */
	readonly written: string;
	/** Name of the symbol. */
	readonly title?: string;
	readonly help: string;
}

export const WORDS: readonly Word[] = [
${words.map(word).join("\n")}
];
`,
		},
	];
}
