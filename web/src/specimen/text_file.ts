/**
 * A plant as a file of its grammar's text: `.growth`, `.stand`. What the text does not say, its preset, seed and parameters, stands in
 * a comment in the first line as a link's query: `/* Panicle ?v=2&model=growth&preset=oak` and the comment's end.
 */
import { decodeQuery, encodeQuery } from "./link";
import type { ModelSchema } from "./model_schema";
import type { Specimen } from "./specimen";

const FIRST_LINE = /^\uFEFF?\/\* Panicle (\?\S*) \*\/\r?\n/;

/** What a file of a text holds. */
export interface TextFile {
	/** Of a link without its text; undefined where the file says none. */
	readonly query: string | undefined;
	/** Without the comment that has it. */
	readonly text: string;
}

/** @param text what the specimen grows by */
export function writeTextFile<S extends Specimen>(species: ModelSchema<S>, specimen: S, text: string): string {
	// Nothing in it ends the comment.
	const query = encodeQuery(species, specimen).replaceAll("*/", "*%2F");
	return `/* Panicle ${query} */\n${text}`;
}

/** Any text is a file: one that was not written here has no query. */
export function readTextFile(file: string): TextFile {
	const [line, query] = FIRST_LINE.exec(file) ?? [""];
	return { query, text: file.slice(line.length) };
}

/** The specimen that the file says, but for its text; undefined where the file says none. */
export function specimenOf<S extends Specimen>(species: ModelSchema<S>, { query }: TextFile): S | undefined {
	return query === undefined ? undefined : decodeQuery(species, query).specimen;
}
