/** Tables for a spreadsheet or a data frame, as in RFC 4180: commas and CRLF, the first row is the header. */

/** Null is an empty cell: the value does not apply. */
export type CsvValue = string | number | null;

export function writeCsv(rows: readonly (readonly CsvValue[])[]): string {
	return rows.map((row) => `${row.map(written).join(",")}\r\n`).join("");
}

/** The text of a cell, in quotes where it contains separators. */
function written(cell: CsvValue): string {
	if (cell === null) return "";
	const text = String(cell);
	return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
