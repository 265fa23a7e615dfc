/** Reads ranges in comments: `0 … 90`, `0...90`, `0..90 step 5`, `0 to 90`, `−1 – 1`. */

export interface RangeWords {
	/** The numbers as they are written. */
	readonly low: string;
	readonly high: string;
	readonly step: string | undefined;
	/** The rest of the comment. */
	readonly description: string;
}

/**
 * Returns the first range in a text, such as `0 … 90 step 5`; undefined if there is none. At each number it looks for a
 * separator and a second number, and goes on behind a number without them: linear in the length of the text.
 */
export function findRange(text: string): RangeWords | undefined {
	for (let at = 0; at < text.length; ) {
		const lowEnd = numberEnd(text, at);
		if (lowEnd === at) {
			at++;
			continue;
		}
		const separated = separatorEnd(text, skipBlanks(text, lowEnd));
		const start = separated === undefined ? lowEnd : skipBlanks(text, separated);
		const highEnd = separated === undefined ? start : numberEnd(text, start);
		if (highEnd === start) {
			at = separated ?? lowEnd;
			continue;
		}
		const [from, end] = stepAt(text, highEnd);
		return {
			low: text.slice(at, lowEnd),
			high: text.slice(start, highEnd),
			step: end > from ? text.slice(from, end) : undefined,
			description: text.slice(0, at) + text.slice(end),
		};
	}
	return undefined;
}

/** Units as comments write them, and as controls show them. */
const UNITS: Readonly<Record<string, string>> = {
	mm: "mm",
	cm: "cm",
	m: "m",
	metres: "m",
	degrees: "°",
	"°": "°",
	"%": "%",
};

/** Returns the unit with which a description begins: "mm, of the stem" → "mm"; empty if it begins with none. */
export function unitIn(description: string): string {
	const word = description.split(/[\s,;:]/, 1)[0];
	return Object.hasOwn(UNITS, word) ? UNITS[word] : "";
}

/** Removes blanks, commas, semicolons and colons from both ends. */
export function trimSeparators(text: string): string {
	const isSeparator = (at: number) => /[\s,;:]/.test(text[at]);
	let [from, to] = [0, text.length];
	while (from < to && isSeparator(from)) from++;
	while (from < to && isSeparator(to - 1)) to--;
	return text.slice(from, to);
}

/** Returns whether a character is a digit; false beyond the end of a text. */
const isDigit = (char: string | undefined): boolean => char !== undefined && char >= "0" && char <= "9";

/** Returns the index of the first character that is not blank, from an index on. */
function skipBlanks(text: string, from: number): number {
	let at = from;
	while (at < text.length && /\s/.test(text[at])) at++;
	return at;
}

/** Returns the index behind the digits that begin at an index. */
function digitsEnd(text: string, from: number): number {
	let at = from;
	while (isDigit(text[at])) at++;
	return at;
}

/**
 * Returns the index behind the number that begins at an index; that index itself if there is none. A number does not
 * include a dot that another dot follows.
 */
function numberEnd(text: string, from: number): number {
	const start = from + Number(text[from] === "-" || text[from] === "−");
	const whole = digitsEnd(text, start);
	const isPoint = text[whole] === "." && text[whole + 1] !== ".";
	const end = isPoint ? digitsEnd(text, whole + 1) : whole;
	return end > start + Number(isPoint && whole === start) ? end : from;
}

/** Returns the index behind the separator of a range (`…`, `–`, `..`, `...`, `to`); undefined if there is none. */
function separatorEnd(text: string, from: number): number | undefined {
	if (text[from] === "…" || text[from] === "–") return from + 1;
	if (text.startsWith("...", from)) return from + 3;
	if (text.startsWith("..", from)) return from + 2;
	const isWord = (char: string | undefined) => char !== undefined && /\w/.test(char);
	return text.startsWith("to", from) && !isWord(text[from - 1]) && !isWord(text[from + 2]) ? from + 2 : undefined;
}

/** Returns the start and end of the number behind `step`; the same index twice if there is none. */
function stepAt(text: string, from: number): readonly [from: number, end: number] {
	let at = skipBlanks(text, from);
	if (text[at] === ",") at = skipBlanks(text, at + 1);
	if (!text.startsWith("step", at)) return [from, from];
	const start = skipBlanks(text, at + "step".length);
	const end = numberEnd(text, start);
	return end > start ? [start, end] : [from, from];
}
