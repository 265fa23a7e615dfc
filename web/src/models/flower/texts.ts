import { blanked } from "../../grammar_editor/comments";
import { presetTexts } from "../../specimen/preset_texts";
import { PRESETS } from "./presets.generated";

export const { fetchTexts, fetchedText } = presetTexts(PRESETS, () => import("./texts.generated"));

/** What the text that a flower grows by calls variables of its own: `#define name=`. How many steps it has is a parameter. */
export async function variablesIn(flower: { readonly grammar?: string; readonly preset: string }): Promise<string[]> {
	if (flower.grammar === undefined) await fetchTexts();
	const bare = uncommented(fetchedText(flower) ?? "");
	const modules = bare.search(/^[ \t]*#[ \t]*module\b/m);
	const own = modules < 0 ? bare : bare.slice(0, modules);
	const names = own.matchAll(/^[ \t]*#[ \t]*define[ \t]+(\p{L}[\p{L}\p{N}_]*)[ \t]*=/gmu);
	return [...names].map(([, name]) => name).filter((name) => name !== "finalStep");
}

/** Whether anything of a flower depends on its age; yes of a text that has not been fetched. */
export function usesAge(flower: { readonly grammar?: string; readonly preset: string }): boolean {
	const text = fetchedText(flower);
	if (text !== lastUsesAge?.text) lastUsesAge = { text, isActive: text === undefined || isOfAge(uncommented(text)) };
	return lastUsesAge?.isActive ?? true;
}

/** The word itself, or colours of buds and of what has wilted. */
function isOfAge(text: string): boolean {
	if (/\bage\b/.test(text)) return true;
	const materials = text.split("\n").filter((line) => /^[ \t]*#[ \t]*material\b/.test(line));
	// Within quotes it is a name.
	return materials.some((line) => line.match(/"?\b(?:bud|wilted)\b/g)?.some((word) => !word.startsWith('"')));
}

/** It is asked at every change of a document, and texts are long. */
let lastUsesAge: { readonly text: string | undefined; readonly isActive: boolean } | undefined;

/** The text with blanks for its comments, those between two `@` too; lines stay. One that is never closed goes on to the end. */
export const uncommented = (text: string): string => text.replace(/@[^@]*(?:@|$)|\/\*[\s\S]*?(?:\*\/|$)/g, blanked);
