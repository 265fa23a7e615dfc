/** Messages for a terminal, which may quote files and links that others wrote. */

/** Characters of the longest line that is printed whole. */
const LONGEST_LINE = 1000;
/** Controls other than the line feed and the tab, by which a mark is placed below a quoted line, and marks that change the direction of the text around them. */
const UNPRINTABLE = /(?![\n\t])[\p{Cc}\u2028\u2029\u202a-\u202e\u2066-\u2069]/gu;

/** A message whose control characters are written as `\u{1b}`, with long lines cut: a quoted text cannot steer the terminal. */
export function printable(message: string): string {
	return message
		.split("\n")
		.map((line) => (line.length > LONGEST_LINE ? `${line.slice(0, LONGEST_LINE)}…` : line))
		.join("\n")
		.replace(UNPRINTABLE, (character) => `\\u{${(character.codePointAt(0) ?? 0).toString(16)}}`);
}
