import { blankComments } from "../../grammar_editor/comments";
import { presetTexts } from "../../specimen/preset_texts";
import { PRESETS } from "./presets.generated";
import type { GrammarSpecimen } from "./specimen";

export const { fetchTexts, fetchedText } = presetTexts(PRESETS, () => import("./texts.generated"));

/** The text that a specimen grows from: its own, or else its preset's. */
export async function textOf(specimen: Pick<GrammarSpecimen, "grammar" | "preset">): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return fetchedText(specimen) ?? "";
}

/** Whether a text's branches keep within growth areas. */
export const usesAreas = (text: string): boolean => /\b(bound|reach)\s*\(/.test(text);

/** The text of a preset by its name. */
export const presetText = (preset: string): Promise<string> => textOf({ preset });

/** The names to which the text that a specimen grows by lets values be given: of its `#define`s and `#input`s. */
export async function definedNames(specimen: Pick<GrammarSpecimen, "grammar" | "preset">): Promise<string[]> {
	const bare = blankComments(await textOf(specimen));
	return [...bare.matchAll(/^[ \t]*#[ \t]*(?:define|input)[ \t]+(\p{L}[\p{L}\p{N}_]*)/gmu)].map(([, name]) => name);
}
