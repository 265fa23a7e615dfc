/** A specimen's text as a file: with its constants and steps in it, so that it grows the same plant wherever it is read. */
import { withConstants } from "../../grammar_editor/outline";
import type { GrammarSpecimen } from "./specimen";
import { textOf } from "./texts";

/** The text of a `.lsys`. */
export async function writtenText(specimen: GrammarSpecimen): Promise<string> {
	return withValues(await textOf(specimen), specimen);
}

/** A text in which the `#define`s and the derivation length say what a specimen says; what the text does not have is left out. */
export function withValues(text: string, { constants, steps }: Pick<GrammarSpecimen, "constants" | "steps">): string {
	const written = withConstants(text, constants);
	if (steps === undefined) return written;
	const length = lengthIn(written);
	if (length) return `${written.slice(0, length.from)}${steps}${written.slice(length.to)}`;
	return written.replace(/^[ \t]*axiom[ \t]*:/m, (axiom) => `derivation length: ${steps}\n${axiom}`);
}

/** The place of the derivation length in a text: from behind its colon to the blanks and the comment that end its line. */
function lengthIn(text: string): { from: number; to: number } | undefined {
	for (const head of text.matchAll(/^[ \t]*derivation[ \t]+length[ \t]*:[ \t]*/gm)) {
		const from = head.index + head[0].length;
		const end = text.indexOf("\n", from);
		const line = text.slice(from, end < 0 ? undefined : end);
		const slash = line.indexOf("/");
		if (slash >= 0 && line[slash + 1] !== "*") continue;
		return { from, to: from + (slash < 0 ? line : line.slice(0, slash)).trimEnd().length };
	}
	return undefined;
}
