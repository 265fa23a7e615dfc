/** Schema of a flower's document: its parameters, presets and further fields. */
import { constantValues } from "../../specimen/constants";
import { grammarText } from "../../specimen/grammar_text";
import type { ModelSchema } from "../../specimen/model_schema";
import { translatedPresets } from "../../specimen/translated_tables";
import { PRESET_KINDS, PRESETS } from "./presets.generated";
import type { FlowerSpecimen } from "./specimen";
import { FLOWER_TABLE } from "./table";
import { variablesIn } from "./texts";

/** Preset of a link without `preset`. */
export const DEFAULT_PRESET = "tulip";

/**
 * Matches an axiom, which every flower's grammar has and no L-system. Here and below, blanks match in one way only:
 * any text may come, and backtracking would take too long.
 */
const AXIOM = /^[ \t]*#[ \t]*axiome?\b/m;

/**
 * Further signs of a flower's grammar; it has at least one: faces in a production, a module, a volume's numbers, or a
 * split volume.
 */
const OWN = [
	/\]\s*(?:_|(?:\{\s*)?(?:[OE]|C\d+|C\())/,
	/^[ \t]*#[ \t]*module\b/m,
	/^[ \t]*#[ \t]*define[ \t]+\p{L}[\p{L}\p{N}_]*[ \t]*\((?:[^()\n]*,)?[ \t]*(?:<[ \t]*)?(?:-[ \t]*)?[\d.]/mu,
	/-[ \t]*(?:[OE]|C\d+)[ \t]*(?:--?>|→)/,
];

/** Matches the XML of Table 4: it begins with an element of a grammar, or with such an element inside another. */
const XML =
	/^\uFEFF?\s*<(?:[?!]|[\p{L}_][^>]*>\s*<(?:volume|variable|axiom|rule|statement)\b|(?:volume|variable|axiom|rule)\b)/u;

/** Returns whether a text is the XML of a flower's grammar. */
export const isXml = (text: string): boolean => XML.test(text);

export const FLOWER: ModelSchema<FlowerSpecimen> = {
	name: "flower",
	table: FLOWER_TABLE,
	presets: translatedPresets("flower", PRESETS, PRESET_KINDS, DEFAULT_PRESET),
	details: [
		constantValues<FlowerSpecimen>(variablesIn),
		grammarText((text) => isXml(text) || (AXIOM.test(text) && OWN.some((sign) => sign.test(text)))),
	],
};
