/** Tables for a spreadsheet or a data frame, as RFC 4180 has them: commas and CRLF, the first row their header. */

/** Null is an empty cell: what does not apply. */
export type Cell = string | number | null;

export function writeCsv(rows: readonly (readonly Cell[])[]): string {
	return rows.map((row) => `${row.map(written).join(",")}\r\n`).join("");
}

/** Text is quoted where it holds what would end a cell. */
function written(cell: Cell): string {
	if (cell === null) return "";
	const text = String(cell);
	return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
