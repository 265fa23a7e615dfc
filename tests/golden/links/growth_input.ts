/** The inputs of a link's plant: links with different inputs must have different fingerprints. */
import { textOf } from "../../../web/src/models/grammar/texts";
import type { Model } from "../../../web/src/models/model";
import type { WithGrammar } from "../../../web/src/specimen/grammar_text";
import { decodeLink, linkParts } from "../../../web/src/specimen/link";
import type { Specimen } from "../../../web/src/specimen/specimen";

/** Fields that do not affect growth, or do so only through parameters or the text. */
const NO_INPUT = ["v", "model", "preset", "parameters", "look", "grammar"];

/** A parameter or field that leaves the segments and organs, and with them the fingerprint, as they are. */
interface Exception {
	readonly model: string;
	readonly field: string;
	/** Where that is so; everywhere where absent. */
	when?(specimen: Specimen, model: Model, text: string | undefined): boolean;
}

/** A random number, or a production with a probability. */
const CHANCE = /\b(n?ran|RND)\s*\(|-->[^:]*:\s*[\d.]+/;

const EXCEPTIONS: readonly Exception[] = [
	// The skin of the berries, and the cane above the bunch, are meshes alone.
	{ model: "bunch", field: "fruit" },
	{ model: "bunch", field: "cane" },
	{ model: "bunch", field: "wing_side", when: ({ parameters }) => parameters.wing === 0 },
	// The natural procedure has no use for the numbers of segments.
	{
		model: "bunch",
		field: "inputs",
		when: (specimen, { table }) => table.option(specimen, "procedure") === "natural",
	},
	{ model: "grammar", field: "sides" },
	// Most grammars are deterministic.
	{ model: "grammar", field: "seed", when: (_specimen, _model, text = "") => !CHANCE.test(text) },
];

/** Grammars whose signal has reached its end after the last step: their two strings draw the same. */
const SAME_DRAWING = [["signal-acropetal", "signal-basipetal"]];

const withoutComments = (text: string) => text.replace(/\/\*[\s\S]*?\*\//g, "").replace(/\s+/g, " ");

/** The values from which a link's plant grows, by name. */
export async function growthInput(model: Model, link: string): Promise<Record<string, unknown>> {
	const { query, fragment } = linkParts(link);
	const { specimen } = await decodeLink(model, query, fragment);
	const text = model.name === "grammar" ? withoutComments(await textOf(specimen)) : (specimen as WithGrammar).grammar;
	const parameters = model.table.core.filter((entry) => model.table.isActive(specimen, entry));
	const fields = Object.entries(specimen).filter(([field]) => !NO_INPUT.includes(field));
	const input: Record<string, unknown> = {
		...Object.fromEntries(parameters.map(({ key }) => [key, specimen.parameters[key]])),
		...Object.fromEntries(fields),
		text: SAME_DRAWING.find((presets) => presets.includes(specimen.preset))?.[0] ?? text,
	};
	for (const { model: name, field, when } of EXCEPTIONS)
		if (name === model.name && (when?.(specimen, model, text) ?? true)) delete input[field];
	return input;
}
