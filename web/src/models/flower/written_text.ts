/** A flower's text as a file: with its values and steps in it, so that it grows the same flower wherever it is read. */
import { outlineOf, withConstants, wordOf } from "../../grammar_editor/outline";
import type { FlowerSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";
import { scan } from "./ui/language";

/** The text of a `.gl3`. */
export async function fileText(specimen: FlowerSpecimen): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return writtenText(fetchedText(specimen) ?? "", specimen);
}

/** The text with a document's values and steps in front of its modules; what the text does not have is left out. */
export function writtenText(
	text: string,
	{ constants, parameters: { steps } }: Pick<FlowerSpecimen, "constants" | "parameters">,
): string {
	// How many steps it has is a parameter, and a value of that name changes nothing.
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
