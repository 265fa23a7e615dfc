/** The table of a series: a line for each plant, with all that brings it back and what was measured. */
import { type Cell, writeCsv } from "../export/csv";
import { measureValues } from "../export/measures";
import type { Grown, Member, Series } from "./series";

/** What stands before the values and the measures. */
const FIRST = ["seed", "file", "bytes", "crc32", "fingerprint", "link"] as const;

/** Names of the columns: a varied parameter's is `set_age`, since measures may be called like parameters. */
export function columnsOf({ model, varied }: Series): string[] {
	const measures = model.table.measures.map(({ key }) => key);
	return [...FIRST, ...varied.map(({ entry }) => `set_${entry.key}`), ...measures, "notes"];
}

/** A grown plant's line. */
export function rowOf({ model }: Series, { seed, file, link, values }: Member, { plant, bytes, sum }: Grown): Cell[] {
	const measures = measureValues(model.table, plant).map(([, value]) => value);
	return [seed, file, bytes.length, sum, plant.fingerprint, link, ...values, ...measures, plant.notes.join(" ")];
}

/** The line of a plant that could not be grown: no file, and why. */
export function failedRow({ model }: Series, { seed, link, values }: Member, why: string): Cell[] {
	return [
		seed,
		null,
		null,
		null,
		null,
		link,
		...values,
		...model.table.measures.map(() => null),
		why.replaceAll(/\s+/g, " "),
	];
}

export const written = (row: readonly Cell[]): string => writeCsv([row]);

/** What a line says of its file. */
export interface Line {
	readonly file: string;
	readonly bytes: number;
	readonly sum: string;
	readonly link: string;
	/** As it was read, to be written again. */
	readonly text: string;
}

/**
 * The whole lines of a table by their files, whatever else is in the text: a last one that broke off is not among them.
 * Undefined where the text is the table of another series: its columns are others.
 */
export function readLines(series: Series, text: string): Map<string, Line> | undefined {
	const [header, ...rows] = splitRows(text);
	const columns = columnsOf(series);
	if (header !== undefined && header !== written(columns)) return undefined;
	const lines = rows.map((row) => {
		const [, file, bytes, sum, , link] = cellsOf(row);
		return { file, bytes: Number(bytes), sum, link, text: row };
	});
	return new Map(lines.filter(({ file }) => file !== "").map((line) => [line.file, line]));
}

/** Rows with the CRLF that ends them: none within quotation marks does. */
function splitRows(text: string): string[] {
	return text.match(/(?:"(?:[^"]|"")*"|[^"\r\n])*\r\n/g) ?? [];
}

function cellsOf(row: string): string[] {
	const cells = row.slice(0, -2).match(/(?<=^|,)(?:"(?:[^"]|"")*"|[^",]*)/g) ?? [];
	return cells.map((cell) => (cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell));
}
