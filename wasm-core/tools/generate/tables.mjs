/** The tables in wasm-core/parameters that belong to a model: `<model>.json` and `<model>.measures.json`. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder } from "../repository.mjs";

/**
 * The C++ namespace of a table's model, below panicle: the model's name, within that of its family where it has one.
 */
export const namespaceOf = (table) => (table.family ? `${table.family}::${table.model}` : table.model);

/**
 * Reads the tables of all models of one kind, in the order of the models' names.
 * @param {".json" | ".measures.json"} ending
 */
export function tablesOf(ending) {
	return readdirSync(join(coreFolder, "parameters"))
		.filter((name) => name.endsWith(ending) && !name.slice(0, -ending.length).includes("."))
		.sort()
		.map((name) => ({
			model: name.slice(0, -ending.length),
			source: `wasm-core/parameters/${name}`,
			table: JSON.parse(readFileSync(join(coreFolder, "parameters", name), "utf8")),
		}))
		.filter(({ model, table }) => table.model === model);
}

/** The first line of every file that is made from a table. */
export function noticeOf(source) {
	return `Made from ${source} by wasm-core/tools/generate.mjs; edit the table, not this.`;
}
