/** Summary of a text's plant in words: for the caption, the picture's description and screen readers. */
import type { GrammarPlant } from "./grammar_plant";

/** Returns "1,240 modules, 380 segments, 24 organs". */
export function grammarInWords({ counts }: GrammarPlant): string {
	const parts = [counted(counts.modules ?? 0, "module"), counted(counts.segments ?? 0, "segment")];
	if (counts.organs > 0) parts.push(counted(counts.organs, "organ"));
	return parts.join(", ");
}

const counted = (count: number, noun: string) => `${count.toLocaleString("en-GB")} ${noun}${count === 1 ? "" : "s"}`;

/** Longest title, in characters. */
const LONGEST_TITLE = 60;

/** Returns the first line of the comment at the start of a text, which is its title in presets. */
export function titleOfText(text: string): string {
	const start = text.trimStart();
	const comment = start.startsWith("/*") ? start.slice(2).trimStart() : "";
	const end = comment.search(/[\n*]/);
	const line = comment.slice(0, Math.max(0, end)).trimEnd();
	const isTitle = line !== "" && line.length <= LONGEST_TITLE && (comment[end] === "\n" || comment[end + 1] === "/");
	return isTitle ? line : "A grammar of one’s own";
}
