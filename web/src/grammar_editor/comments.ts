/**
 * Comments of grammars: from `/*` to the next `*` and `/`. An unclosed comment extends to the end of the text, where
 * the core reports it.
 */

/** Replaces comments in a text by blanks; positions and lines stay the same. */
export const blankComments = (text: string): string => text.replace(/\/\*[\s\S]*?(?:\*\/|$)/g, blanked);

/** Replaces a string by blanks; line breaks stay. */
export const blanked = (piece: string): string => piece.replace(/[^\n]/g, " ");

/** Returns the text of a comment without its delimiters. */
export function insideComment(comment: string): string {
	let from = 2;
	let to = comment.endsWith("*/") ? comment.length - 2 : comment.length;
	while (comment[from] === "*") from++;
	while (to > from && comment[to - 1] === "*") to--;
	return comment.slice(from, Math.max(from, to));
}
