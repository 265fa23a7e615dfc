/** The texts of presets. They are no part of what a page loads first: they are fetched together when one is asked for. */
import { PRESETS } from "./presets.generated";
import type { GrammarSpecimen } from "./specimen";

let texts: Readonly<Record<string, string>> | undefined;

const textNames = new Map(PRESETS.map(({ name, text }) => [name, text]));

/** Fetches them; rejects where that fails, and tries again with the next call. */
export async function fetchTexts(): Promise<void> {
	texts ??= (await import("./texts.generated")).TEXTS;
}

/** What a specimen grows from; undefined where that is its preset's and has not been fetched. */
export function fetchedText({ grammar, preset }: Pick<GrammarSpecimen, "grammar" | "preset">): string | undefined {
	return grammar ?? texts?.[textNames.get(preset) ?? ""];
}

/** The text that a specimen grows from: its own, or else its preset's. */
export async function textOf(specimen: Pick<GrammarSpecimen, "grammar" | "preset">): Promise<string> {
	if (specimen.grammar === undefined) await fetchTexts();
	return fetchedText(specimen) ?? "";
}

/** Whether a text's branches keep within growth areas. */
export const asksForAreas = (text: string): boolean => /\b(bound|reach)\s*\(/.test(text);

/** The text of a preset by its name. */
export const presetText = (preset: string): Promise<string> => textOf({ preset });
