/** A specimen's text as a file: with its constants and steps in it, so that it grows the same plant wherever it is read. */
import { withConstants } from "../../controls/grammar/outline";
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
	const length = /^([ \t]*derivation[ \t]+length[ \t]*:[ \t]*)[^\n/]*?([ \t]*(?:\/\*.*)?)$/m;
	if (length.test(written)) return written.replace(length, (_, before, after) => `${before}${steps}${after}`);
	return written.replace(/^[ \t]*axiom[ \t]*:/m, (axiom) => `derivation length: ${steps}\n${axiom}`);
}
