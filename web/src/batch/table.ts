/** The table of a series: a row for each plant, with its link and measures. */
import { classesOf, descriptorsOf } from "../formats/classes";
import { type CsvValue, writeCsv } from "../formats/csv";
import { measureValues } from "../formats/measures";
import { splitCells, splitRows } from "./csv_rows";
import type { GrownSeriesPlant, Series, SeriesPlant } from "./series";

/**
 * Returns the columns of a plant's files: `file`, `bytes`, `crc32` for the first kind, `file_json` and so on for each
 * further one.
 */
function fileColumns({ formats }: Series): (readonly [file: string, bytes: string, sum: string])[] {
	const keyed = (suffix: string) => [`file${suffix}`, `bytes${suffix}`, `crc32${suffix}`] as const;
	return formats.map((format, at) => keyed(at === 0 ? "" : `_${format}`));
}

/**
 * Returns the names of the columns: `set_age` for a varied parameter, since measures may have names of parameters. With
 * targets, `from` is the link before the search, `target_bunch_length` the target value, and `missed` names the missed
 * measures.
 */
export function columnsOf(series: Series): string[] {
	const { model, varied, goals = [] } = series;
	return [
		...["number", "seed", ...fileColumns(series).flat(), "fingerprint", "link"],
		...(goals.length > 0 ? ["from", ...goals.map(({ measure }) => `target_${measure}`), "missed"] : []),
		...varied.map(({ entry }) => `set_${entry.key}`),
		...model.table.measures.map(({ key }) => key),
		...descriptorsOf(model).flatMap(({ oiv }) => [`oiv_${oiv}_class`, `oiv_${oiv}_words`]),
		"notes",
	];
}

/** The cells of a row by column; missing ones are empty. */
type Cells = Record<string, CsvValue>;

/** Returns the cells of a plant that has not grown yet. */
function memberCells({ varied, goals = [] }: Series, { number, seed, values, aims, link }: SeriesPlant): Cells {
	return {
		...{ number, seed },
		...(goals.length > 0 ? { from: link } : {}),
		...Object.fromEntries(aims.map(({ measure, value }) => [`target_${measure}`, value])),
		...Object.fromEntries(varied.map(({ entry }, at) => [`set_${entry.key}`, values[at]])),
	};
}

/** Returns the row of a grown plant. */
export function rowOf(
	series: Series,
	member: SeriesPlant,
	{ plant, specimen, link, missed, files }: GrownSeriesPlant,
): CsvValue[] {
	const cells = memberCells(series, member);
	fileColumns(series).forEach(([name, bytes, sum], at) => {
		Object.assign(cells, { [name]: files[at].name, [bytes]: files[at].bytes.length, [sum]: files[at].sum });
	});
	for (const [{ key }, value] of measureValues(series.model.table, plant)) cells[key] = value;
	for (const { oiv, class: note, words } of Object.values(classesOf(series.model, plant, specimen)))
		Object.assign(cells, { [`oiv_${oiv}_class`]: note, [`oiv_${oiv}_words`]: words });
	const { fingerprint, notes } = plant;
	return inColumns(series, { ...cells, fingerprint, link, missed: missed.join(" "), notes: notes.join(" ") });
}

/** Returns the row of a plant that could not be grown: no file, and the reason. */
export function failedRow(series: Series, member: SeriesPlant, why: string): CsvValue[] {
	return inColumns(series, { ...memberCells(series, member), link: member.link, notes: why.replaceAll(/\s+/g, " ") });
}

/** Returns cells in the order of the columns; missing ones are null. */
const inColumns = (series: Series, cells: Cells): CsvValue[] =>
	columnsOf(series).map((column) => cells[column] ?? null);

/** Returns the text of a row. */
export const written = (row: readonly CsvValue[]): string => writeCsv([row]);

/** A row of a table that was read. */
export interface TableRow {
	/** In the order of the formats. */
	readonly files: readonly { readonly name: string; readonly bytes: number; readonly sum: string }[];
	/** The member's link, from before the search for parameters. */
	readonly link: string;
	/** Whether a target was missed. */
	readonly missed: boolean;
	/** The text of the row, to write it again. */
	readonly text: string;
}

/**
 * Returns the whole rows of a table by the numbers of their plants, without failed plants and an unfinished last row.
 * Undefined where the text is the table of another series: it has other columns.
 */
export function readLines(series: Series, text: string): Map<number, TableRow> | undefined {
	const [header, ...rows] = splitRows(text);
	const columns = columnsOf(series);
	if (header !== undefined && header !== written(columns)) return undefined;
	const lines = new Map<number, TableRow>();
	for (const row of rows) {
		const cells = new Map(splitCells(row).map((cell, at) => [columns[at], cell]));
		const cell = (column: string) => cells.get(column) ?? "";
		const files = fileColumns(series).map(([name, bytes, sum]) => ({
			...{ name: cell(name), bytes: Number(cell(bytes)), sum: cell(sum) },
		}));
		if (files.some(({ name }) => name === "")) continue;
		const link = cells.get("from") ?? cell("link");
		lines.set(Number(cell("number")), { files, link, missed: cell("missed") !== "", text: row });
	}
	return lines;
}
