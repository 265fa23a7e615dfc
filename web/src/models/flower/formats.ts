/** Files of a flower besides those of every plant: its grammar, in both forms of Petrenko's Table 4. */
import type { Format } from "../model";
import type { FlowerPlant } from "./flower_plant";
import type { FlowerSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";

async function textOf(specimen: FlowerSpecimen): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return writtenText(fetchedText(specimen) ?? "", specimen);
}

/** The text with the document's values and steps in front of its modules, so that it grows the same flower wherever it is read. */
export function writtenText(
	text: string,
	{ constants, parameters: { steps } }: Pick<FlowerSpecimen, "constants" | "parameters">,
) {
	const modules = text.search(/^[ \t]*#module\b/m);
	let own = modules < 0 ? text : text.slice(0, modules);
	const behind = text.slice(own.length);
	for (const [name, value] of Object.entries(constants)) own = own.replace(defining(name), `$1${value}`);
	if (!(steps > 0)) return own + behind;
	const line = defining("finalStep");
	return (line.test(own) ? own.replace(line, `$1${steps}`) : `${own.trimEnd()}\n#define finalStep=${steps}\n`) + behind;
}

/** The line that gives a variable its value, up to the comment behind that. */
const defining = (name: string): RegExp =>
	new RegExp(`^([ \\t]*#[ \\t]*define[ \\t]+${name}[ \\t]*=)(?:[^\\n@/]|/(?!\\*))*?(?=[ \\t]*(?:@|/\\*|$))`, "mu");

export const FLOWER_FORMATS: readonly Format<FlowerSpecimen, FlowerPlant>[] = [
	{
		key: "gl3",
		title: "Grammar",
		about: "The text it grows from: opens here again",
		suffix: ".gl3",
		type: "text/plain",
		make: async (_, specimen) => textOf(specimen),
	},
	{
		key: "xml",
		title: "Grammar as XML",
		about: "The same in the elements of the thesis’s Table 4: opens here again",
		suffix: ".xml",
		type: "application/xml",
		make: async (_, specimen) => (await import("./xml/write")).xmlOf(await textOf(specimen)),
	},
];
