/** The texts that presets of a model grow by. They are no part of what a page loads first: all come together when one is asked for. */

import { comesOf } from "./altered_text";

/** What is known of a preset before its text is there. */
interface Named {
	readonly name: string;
	/** Whose text it has: presets may share one. */
	readonly text: string;
}

export interface PresetTexts {
	/** Fetches them; rejects where that fails, and tries again with the next call. */
	fetchTexts(): Promise<void>;
	/** What a document grows by: its own text, or its preset's; undefined where that has not been fetched. */
	fetchedText(document: { readonly grammar?: string | undefined; readonly preset: string }): string | undefined;
}

/**
 * What a plant with a text of its own is called; undefined of one that grows by its preset's, be it altered. Before that has been fetched
 * nobody can tell.
 */
export function titledBy(own: string, fetchedText: PresetTexts["fetchedText"]) {
	return ({
		grammar,
		preset,
	}: {
		readonly grammar?: string | undefined;
		readonly preset: string;
	}): string | undefined => {
		if (grammar === undefined) return undefined;
		const published = fetchedText({ preset });
		return published !== undefined && comesOf(grammar, published) ? undefined : own;
	};
}

export function presetTexts(
	presets: readonly Named[],
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
