/**
 * Rows and cells of a table that csv.ts wrote (RFC 4180), read in one pass each. The table of an interrupted series may
 * end anywhere.
 */

/**
 * Splits a table into whole rows with their CRLF; a CRLF within quotation marks ends no row. An unfinished last row is
 * left out.
 */
export function splitRows(text: string): string[] {
	const rows: string[] = [];
	let from = 0;
	let isQuoted = false;
	for (let at = 0; at < text.length; at++) {
		if (text[at] === '"') isQuoted = !isQuoted;
		else if (!isQuoted && text[at] === "\n") {
			if (text[at - 1] === "\r") rows.push(text.slice(from, at + 1));
			from = at + 1;
		}
	}
	return rows;
}

/**
 * Returns the values of a row's cells.
 * @param row with its CRLF
 */
export function splitCells(row: string): string[] {
	const cells: string[] = [];
	const end = row.length - "\r\n".length;
	let from = 0;
	let isQuoted = false;
	for (let at = 0; at <= end; at++) {
		if (at < end && row[at] === '"') isQuoted = !isQuoted;
		if (at < end && (isQuoted || row[at] !== ",")) continue;
		cells.push(unquote(row.slice(from, at)));
		from = at + 1;
	}
	return cells;
}

/** Returns a cell without its quotation marks; a doubled one inside is a single one. */
const unquote = (cell: string): string => (cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell);
