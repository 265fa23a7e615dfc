/** The document's side of the model: its table, its presets, and what a specimen of it holds besides. */
import { constantValues } from "../../specimen/constants";
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { Presets } from "../../specimen/presets";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { FlowerSpecimen } from "./specimen";
import { FLOWER_TABLE } from "./table";
import { variablesIn } from "./texts";

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "tulip";

/** A line of each flower's grammar, and of no L-system's. Here as below blanks are each matched in one place alone: any text may come, and of three ways to share them out all would be tried. */
const AXIOM = /^[ \t]*#[ \t]*axiome?\b/m;

/** Of these there is one besides it: the faces that something grows on, a module, a volume's numbers, a volume that is halved. */
const OWN = [
	/\]\s*(?:_|(?:\{\s*)?(?:[OE]|C\d+|C\())/,
	/^[ \t]*#[ \t]*module\b/m,
	/^[ \t]*#[ \t]*define[ \t]+\p{L}[\p{L}\p{N}_]*[ \t]*\((?:[^()\n]*,)?[ \t]*(?:<[ \t]*)?(?:-[ \t]*)?[\d.]/mu,
	/-[ \t]*(?:[OE]|C\d+)[ \t]*(?:--?>|→)/,
];

/** The XML of Table 4: an element of a grammar's begins it, be it within another. */
const XML =
	/^\uFEFF?\s*<(?:[?!]|[\p{L}_][^>]*>\s*<(?:volume|variable|axiom|rule|statement)\b|(?:volume|variable|axiom|rule)\b)/u;

export const isXml = (text: string): boolean => XML.test(text);

export const FLOWER: ModelSchema<FlowerSpecimen> = {
	name: "flower",
	table: FLOWER_TABLE,
	presets: new Presets(PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [
		constantValues<FlowerSpecimen>(variablesIn),
		grammarText((text) => isXml(text) || (AXIOM.test(text) && OWN.some((sign) => sign.test(text)))),
	],
};
