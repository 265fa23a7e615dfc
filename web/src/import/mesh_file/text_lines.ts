/** Splits a text into lines and words lazily, so that a large file is never stored as a list of them. */

const LF = 10;
const CR = 13;
const BLANK = 32;

/** Lines that end with LF, CR LF or CR alone, without their ends. */
export function* linesOf(text: string): Generator<string> {
	for (let start = 0; start <= text.length; ) {
		const end = endOfLine(text, start);
		yield text.slice(start, end);
		start = end + (text.startsWith("\r\n", end) ? 2 : 1);
	}
}

/** Returns the index of the first line end from `start` on, or the text's length. */
function endOfLine(text: string, start: number): number {
	let end = start;
	while (end < text.length && text.charCodeAt(end) !== LF && text.charCodeAt(end) !== CR) end++;
	return end;
}

/** Words between blanks, tabs and other control characters. */
export function* wordsOf(line: string): Generator<string> {
	for (let start = 0; start < line.length; ) {
		let end = start;
		while (end < line.length && line.charCodeAt(end) > BLANK) end++;
		if (end > start) yield line.slice(start, end);
		start = end + 1;
	}
}
