/** Messages for a terminal, which may quote files and links from others. */

/** The longest line that is printed whole, in characters. */
const LONGEST_LINE = 1000;
/**
 * Control characters except the line feed and the tab, which place a mark below a quoted line, and characters that
 * change the direction of text.
 */
const UNPRINTABLE = /(?![\n\t])[\p{Cc}\u2028\u2029\u202a-\u202e\u2066-\u2069]/gu;

/**
 * Returns a message with its control characters written as `\u{1b}`, and long lines cut: a quoted text cannot control
 * the terminal.
 */
export function printable(message: string): string {
	return message
		.split("\n")
		.map((line) => (line.length > LONGEST_LINE ? `${line.slice(0, LONGEST_LINE)}…` : line))
		.join("\n")
		.replace(UNPRINTABLE, (character) => `\\u{${(character.codePointAt(0) ?? 0).toString(16)}}`);
}
