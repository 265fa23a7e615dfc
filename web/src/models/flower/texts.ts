import { blanked } from "../../grammar_editor/comments";
import { presetTexts } from "../../specimen/preset_texts";
import { PRESETS } from "./presets.generated";

export const { fetchTexts, fetchedText } = presetTexts(PRESETS, () => import("./texts.generated"));

/**
 * Returns the names of a flower's own variables, `#define name=`. Excludes finalStep, which is the parameter `steps`.
 */
export async function variablesIn(flower: { readonly grammar?: string; readonly preset: string }): Promise<string[]> {
	if (flower.grammar === undefined) await fetchTexts();
	const bare = uncommented(fetchedText(flower) ?? "");
	const modules = bare.search(/^[ \t]*#[ \t]*module\b/m);
	const own = modules < 0 ? bare : bare.slice(0, modules);
	const names = own.matchAll(/^[ \t]*#[ \t]*define[ \t]+(\p{L}[\p{L}\p{N}_]*)[ \t]*=/gmu);
	return [...names].map(([, name]) => name).filter((name) => name !== "finalStep");
}

/** Returns whether a flower depends on its age; true if its text has not been fetched. */
export function usesAge(flower: { readonly grammar?: string; readonly preset: string }): boolean {
	const text = fetchedText(flower);
	if (text !== lastUsesAge?.text) lastUsesAge = { text, isActive: text === undefined || isOfAge(uncommented(text)) };
	return lastUsesAge?.isActive ?? true;
}

/** Returns whether a text uses the variable `age`, or colours of buds and of wilting. */
function isOfAge(text: string): boolean {
	if (/\bage\b/.test(text)) return true;
	const materials = text.split("\n").filter((line) => /^[ \t]*#[ \t]*material\b/.test(line));
	// Within quotes it is a material's name.
	return materials.some((line) => line.match(/"?\b(?:bud|wilted)\b/g)?.some((word) => !word.startsWith('"')));
}

/** The last result of `usesAge`, which runs at every change of a document on long texts. */
let lastUsesAge: { readonly text: string | undefined; readonly isActive: boolean } | undefined;

/** Replaces comments by blanks, those between two `@` too; lines stay. An unclosed comment extends to the end. */
export const uncommented = (text: string): string => text.replace(/@[^@]*(?:@|$)|\/\*[\s\S]*?(?:\*\/|$)/g, blanked);
