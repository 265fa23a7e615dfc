/** The texts of presets. A page does not load them at first: the first use fetches all of them together. */

import { isVariantOf } from "./altered_text";

/** A preset and the text it grows by. */
interface NamedText {
	readonly name: string;
	/** The name of the text: presets may share one. */
	readonly text: string;
}

export interface PresetTexts {
	/** Fetches the texts; rejects where that fails, and the next call tries again. */
	fetchTexts(): Promise<void>;
	/** The text of a document: its own, or its preset's; undefined where that has not been fetched. */
	fetchedText(document: { readonly grammar?: string | undefined; readonly preset: string }): string | undefined;
}

/**
 * Makes the title of plants with a text of their own; undefined for plants that grow by their preset's text, altered or
 * not. Before the preset's text has been fetched, a plant counts as having a text of its own.
 */
export function titleForOwnText(own: string, fetchedText: PresetTexts["fetchedText"]) {
	return ({
		grammar,
		preset,
	}: {
		readonly grammar?: string | undefined;
		readonly preset: string;
	}): string | undefined => {
		if (grammar === undefined) return undefined;
		const published = fetchedText({ preset });
		return published !== undefined && isVariantOf(grammar, published) ? undefined : own;
	};
}

/**
 * Makes the store of presets' texts.
 * @param presets names of the presets with those of their texts
 * @param fetch loads the texts by their names
 */
export function presetTexts(
	presets: readonly NamedText[],
	fetch: () => Promise<{ readonly TEXTS: Readonly<Record<string, string>> }>,
): PresetTexts {
	const names = new Map(presets.map(({ name, text }) => [name, text]));
	let texts: Readonly<Record<string, string>> | undefined;
	return {
		async fetchTexts() {
			texts ??= (await fetch()).TEXTS;
		},
		fetchedText: ({ grammar, preset }) => grammar ?? texts?.[names.get(preset) ?? ""],
	};
}
