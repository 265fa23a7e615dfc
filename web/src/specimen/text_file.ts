/**
 * A plant as a file of its grammar's text: `.growth`, `.stand`. Preset, seed and parameters are a link's query in a
 * comment in the first line: `/* Panicle ?v=2&model=growth&preset=oak` and the comment's end.
 */
import { decodeQuery, encodeQuery } from "./link";
import type { ModelSchema } from "./model_schema";
import type { Specimen } from "./specimen";

const FIRST_LINE = /^\uFEFF?\/\* Panicle (\?\S*) \*\/\r?\n/;

/** The contents of a text file. */
export interface TextFile {
	/** Query of a link without its text; undefined where the file has none. */
	readonly query: string | undefined;
	/** The text without the comment that has the query. */
	readonly text: string;
}

/**
 * Writes a text file: the specimen's query in a comment, then the text.
 * @param text the text that the specimen grows by
 */
export function writeTextFile<S extends Specimen>(schema: ModelSchema<S>, specimen: S, text: string): string {
	// The query must not end the comment.
	const query = encodeQuery(schema, specimen).replaceAll("*/", "*%2F");
	return `/* Panicle ${query} */\n${text}`;
}

/** Reads a text file. Any text is valid: one from elsewhere has no query. */
export function readTextFile(file: string): TextFile {
	const [line, query] = FIRST_LINE.exec(file) ?? [""];
	return { query, text: file.slice(line.length) };
}

/** Returns the specimen of the file's query, without the text; undefined where the file has no query. */
export function specimenOf<S extends Specimen>(schema: ModelSchema<S>, { query }: TextFile): S | undefined {
	return query === undefined ? undefined : decodeQuery(schema, query).specimen;
}
