/** Comments of grammars: from `/*` to the next `*` and `/`; one that is never closed goes on to the end, where the core reports it. */

/** The text with blanks for its comments: places and lines stay. */
export const blankComments = (text: string): string => text.replace(/\/\*[\s\S]*?(?:\*\/|$)/g, blanked);

/** A piece of a text as blanks; its lines stay. */
export const blanked = (piece: string): string => piece.replace(/[^\n]/g, " ");

/** The words of a comment, without its delimiters. */
export function insideComment(comment: string): string {
	let from = 2;
	let to = comment.endsWith("*/") ? comment.length - 2 : comment.length;
	while (comment[from] === "*") from++;
	while (to > from && comment[to - 1] === "*") to--;
	return comment.slice(from, Math.max(from, to));
}
