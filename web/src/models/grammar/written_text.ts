/** Writes a specimen's text as a file, with its constants and steps, so that it grows the same plant everywhere. */
import { withConstants } from "../../grammar_editor/outline";
import type { GrammarSpecimen } from "./specimen";
import { textOf } from "./texts";

/** Returns the text of a `.lsys` file. */
export async function writtenText(specimen: GrammarSpecimen): Promise<string> {
	return withValues(await textOf(specimen), specimen);
}

/**
 * Writes a specimen's constants and steps into the `#define`s and the derivation length of a text; constants without a
 * `#define` are dropped.
 */
export function withValues(text: string, { constants, steps }: Pick<GrammarSpecimen, "constants" | "steps">): string {
	const written = withConstants(text, constants);
	if (steps === undefined) return written;
	const length = derivationLength(written);
	if (length) return `${written.slice(0, length.from)}${steps}${written.slice(length.to)}`;
	return written.replace(/^[ \t]*axiom[ \t]*:/m, (axiom) => `derivation length: ${steps}\n${axiom}`);
}

/**
 * Returns the range of the derivation length in a text, from behind its colon to before trailing blanks and comments.
 */
export function derivationLength(text: string): { from: number; to: number } | undefined {
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
