/** Writes a flower's text as a file, with its values and steps, so that it grows the same flower everywhere. */
import { outlineOf, withConstants, wordOf } from "../../grammar_editor/outline";
import type { FlowerSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";
import { scan } from "./ui/language";

/** Returns the text of a `.gl3` file. */
export async function fileText(specimen: FlowerSpecimen): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return writtenText(fetchedText(specimen) ?? "", specimen);
}

/**
 * Writes a document's values and steps into a text, before its modules; values without a definition in the text are
 * dropped.
 */
export function writtenText(
	text: string,
	{ constants, parameters: { steps } }: Pick<FlowerSpecimen, "constants" | "parameters">,
): string {
	// The parameter `steps` sets the number of steps; a value named finalStep has no effect.
	const { finalStep: _, ...own } = constants;
	const pieces = scan(text);
	if (!(steps > 0)) return withConstants(text, own, pieces);
	const { definitions } = outlineOf(text, pieces);
	const written = withConstants(text, { ...own, finalStep: steps }, pieces);
	if (definitions.some(({ name }) => name === "finalStep")) return written;
	const modules = scan(written).find((piece) => piece.kind === "statement" && wordOf(piece) === "#module");
	const front = written.slice(0, modules?.from);
	return `${front.trimEnd()}\n#define finalStep=${steps}\n${written.slice(front.length)}`;
}
