/** Tables for a spreadsheet or a data frame, as in RFC 4180: commas and CRLF, the first row is the header. */

/** Null is an empty cell: the value does not apply. */
export type CsvValue = string | number | null;

/** Returns the text of a table; the first row is the header. */
export function writeCsv(rows: readonly (readonly CsvValue[])[]): string {
	return rows.map((row) => `${row.map(cellText).join(",")}\r\n`).join("");
}

/** Returns the text of a cell, in quotes where it contains separators. */
function cellText(cell: CsvValue): string {
	if (cell === null) return "";
	const text = String(cell);
	return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
