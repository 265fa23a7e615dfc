import { blankComments } from "../../grammar_editor/comments";
import { presetTexts } from "../../specimen/preset_texts";
import { PRESETS } from "./presets.generated";
import type { GrammarSpecimen } from "./specimen";

export const { fetchTexts, fetchedText } = presetTexts(PRESETS, () => import("./texts.generated"));

/** Returns a specimen's text: its own, or else its preset's. */
export async function textOf(specimen: Pick<GrammarSpecimen, "grammar" | "preset">): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return fetchedText(specimen) ?? "";
}

/** Returns whether a text restricts its branches to growth areas. */
export const usesAreas = (text: string): boolean => /\b(bound|reach)\s*\(/.test(text);

/** Returns a preset's text. */
export const presetText = (preset: string): Promise<string> => textOf({ preset });

/** Returns the names of the `#define`s and `#input`s of a specimen's text, whose values can be set. */
export async function definedNames(specimen: Pick<GrammarSpecimen, "grammar" | "preset">): Promise<string[]> {
	const bare = blankComments(await textOf(specimen));
	return [...bare.matchAll(/^[ \t]*#[ \t]*(?:define|input)[ \t]+(\p{L}[\p{L}\p{N}_]*)/gmu)].map(([, name]) => name);
}
