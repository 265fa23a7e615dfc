/** The table of a series: a line for each plant, with all that brings it back and what was measured. */
import { type Cell, writeCsv } from "../export/csv";
import { measureValues } from "../export/measures";
import { cellsOf, splitRows } from "./csv_rows";
import type { Grown, Member, Series } from "./series";

/** What stands before the values and the measures. */
const FIRST = ["number", "seed", "file", "bytes", "crc32", "fingerprint", "link"] as const;

/**
 * Names of the columns: a varied parameter's is `set_age`, since measures may be called like parameters. Where measures are asked for, `from` is
 * the link without that, and `target_bunch_length` what is asked.
 */
export function columnsOf({ model, varied, aims = [] }: Series): string[] {
	const measures = model.table.measures.map(({ key }) => key);
	const asked = aims.map(({ measure }) => `target_${measure}`);
	const from = aims.length > 0 ? ["from"] : [];
	return [...FIRST, ...from, ...asked, ...varied.map(({ entry }) => `set_${entry.key}`), ...measures, "notes"];
}

/** What stands in `from` and `target_…`. */
const askedCells = ({ aims = [] }: Series, { link }: Member): Cell[] =>
	aims.length > 0 ? [link, ...aims.map(({ value }) => value)] : [];

/** A grown plant's line. */
export function rowOf(series: Series, member: Member, { plant, link, bytes, sum }: Grown): Cell[] {
	const { number, seed, file, values } = member;
	const measures = measureValues(series.model.table, plant).map(([, value]) => value);
	const marks = [number, seed, file, bytes.length, sum, plant.fingerprint, link];
	return [...marks, ...askedCells(series, member), ...values, ...measures, plant.notes.join(" ")];
}

/** The line of a plant that could not be grown: no file, and why. */
export function failedRow(series: Series, member: Member, why: string): Cell[] {
	const { number, seed, link, values } = member;
	return [
		number,
		seed,
		null,
		null,
		null,
		null,
		link,
		...askedCells(series, member),
		...values,
		...series.model.table.measures.map(() => null),
		why.replaceAll(/\s+/g, " "),
	];
}

export const written = (row: readonly Cell[]): string => writeCsv([row]);

/** What a line says of its file. */
export interface Line {
	readonly file: string;
	readonly bytes: number;
	readonly sum: string;
	/** The member's link, as it is without what is asked of its measures. */
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
	const { aims = [] } = series;
	const lines = rows.map((row) => {
		const [, , file, bytes, sum, , link, from, ...more] = cellsOf(row);
		const same = aims.every(({ value }, at) => Number(more[at]) === value);
		return { file, bytes: Number(bytes), sum, link: aims.length > 0 ? from : link, text: row, same };
	});
	return new Map(lines.filter(({ file, same }) => file !== "" && same).map((line) => [line.file, line]));
}
