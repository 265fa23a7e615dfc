/** Files of a flower besides those of every plant: its grammar, in both forms of Petrenko's Table 4. */
import type { Format } from "../model";
import type { FlowerPlant } from "./flower_plant";
import type { FlowerSpecimen } from "./specimen";
import { fetchedText, fetchTexts } from "./texts";

async function textOf(specimen: FlowerSpecimen): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return withSteps(fetchedText(specimen) ?? "", specimen.parameters.steps);
}

/** The text with as many steps as the panel gives it, in front of its modules, so that it grows as far wherever it is read. */
function withSteps(text: string, steps: number): string {
	if (!(steps > 0)) return text;
	const modules = text.search(/^[ \t]*#module\b/m);
	const own = modules < 0 ? text : text.slice(0, modules);
	const line = /^([ \t]*#define[ \t]+finalStep[ \t]*=)[^\n@]*/m;
	const said = line.test(own) ? own.replace(line, `$1${steps}`) : `${own.trimEnd()}\n#define finalStep=${steps}\n`;
	return said + text.slice(own.length);
}

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
