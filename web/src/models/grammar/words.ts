/** Summary of a text's plant in words: for the caption, the picture's description and screen readers. */

import type { GrammarPlant } from "./grammar_plant";
import { text } from "./messages.generated";

/** Returns "1,240 modules, 380 segments, 24 organs". */
export function grammarInWords({ counts }: GrammarPlant): string {
	const parts = [text("modules", { count: counts.modules ?? 0 }), text("segments", { count: counts.segments ?? 0 })];
	if (counts.organs > 0) parts.push(text("organs", { count: counts.organs }));
	return parts.join(", ");
}

/** Longest title, in characters. */
const LONGEST_TITLE = 60;

/** Returns the first line of the comment at the start of a text, which is its title in presets. */
export function titleOfText(grammar: string): string {
	const start = grammar.trimStart();
	const comment = start.startsWith("/*") ? start.slice(2).trimStart() : "";
	const end = comment.search(/[\n*]/);
	const line = comment.slice(0, Math.max(0, end)).trimEnd();
	const isTitle = line !== "" && line.length <= LONGEST_TITLE && (comment[end] === "\n" || comment[end + 1] === "/");
	return isTitle ? line : text("own_title");
}
