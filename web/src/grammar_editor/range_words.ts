/** Reads ranges in comments: `0 … 90`, `0...90`, `0..90 step 5`, `0 to 90`, `−1 – 1`. */

export interface RangeWords {
	/** The numbers as they are written. */
	readonly low: string;
	readonly high: string;
	readonly step: string | undefined;
	/** The rest of the comment. */
	readonly words: string;
}

/** Returns the first range in a text; undefined if there is none. Linear in the length of the text. */
export function findRange(text: string): RangeWords | undefined {
	for (let at = 0; at < text.length; ) {
		const low = numberEnd(text, at);
		if (low === at) {
			at++;
			continue;
		}
		const separated = separatorEnd(text, skipBlanks(text, low));
		const start = separated === undefined ? low : skipBlanks(text, separated);
		const high = separated === undefined ? start : numberEnd(text, start);
		if (high === start) {
			at = separated ?? low;
			continue;
		}
		const [from, end] = stepAt(text, high);
		return {
			low: text.slice(at, low),
			high: text.slice(start, high),
			step: end > from ? text.slice(from, end) : undefined,
			words: text.slice(0, at) + text.slice(end),
		};
	}
	return undefined;
}

/** Removes blanks, commas, semicolons and colons from both ends. */
export function trimSeparators(words: string): string {
	const isSeparator = (at: number) => /[\s,;:]/.test(words[at]);
	let [from, to] = [0, words.length];
	while (from < to && isSeparator(from)) from++;
	while (from < to && isSeparator(to - 1)) to--;
	return words.slice(from, to);
}

const isDigit = (char: string | undefined): boolean => char !== undefined && char >= "0" && char <= "9";

function skipBlanks(text: string, from: number): number {
	let at = from;
	while (at < text.length && /\s/.test(text[at])) at++;
	return at;
}

function digitsEnd(text: string, from: number): number {
	let at = from;
	while (isDigit(text[at])) at++;
	return at;
}

/** The end of the number that begins at a place; the place itself where none does. A number does not include a dot that another dot follows. */
function numberEnd(text: string, from: number): number {
	const start = from + Number(text[from] === "-" || text[from] === "−");
	const whole = digitsEnd(text, start);
	const isPoint = text[whole] === "." && text[whole + 1] !== ".";
	const end = isPoint ? digitsEnd(text, whole + 1) : whole;
	return end > start + Number(isPoint && whole === start) ? end : from;
}

/** The end of the separator of a range; undefined if there is none at that place. */
function separatorEnd(text: string, from: number): number | undefined {
	if (text[from] === "…" || text[from] === "–") return from + 1;
	if (text.startsWith("...", from)) return from + 3;
	if (text.startsWith("..", from)) return from + 2;
	const isWord = (char: string | undefined) => char !== undefined && /\w/.test(char);
	return text.startsWith("to", from) && !isWord(text[from - 1]) && !isWord(text[from + 2]) ? from + 2 : undefined;
}

/** The start and end of the number behind `step`; the same place twice if there is none. */
function stepAt(text: string, from: number): readonly [from: number, end: number] {
	let at = skipBlanks(text, from);
	if (text[at] === ",") at = skipBlanks(text, at + 1);
	if (!text.startsWith("step", at)) return [from, from];
	const start = skipBlanks(text, at + "step".length);
	const end = numberEnd(text, start);
	return end > start ? [start, end] : [from, from];
}
