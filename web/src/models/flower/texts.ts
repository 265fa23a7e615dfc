import { presetTexts } from "../../specimen/preset_texts";
import { PRESETS } from "./presets.generated";

export const { fetchTexts, fetchedText } = presetTexts(PRESETS, () => import("./texts.generated"));

/** What the text that a flower grows by calls variables of its own: `#define name=`. How many steps it has is a parameter. */
export async function variablesIn(flower: { readonly grammar?: string; readonly preset: string }): Promise<string[]> {
	if (flower.grammar === undefined) await fetchTexts();
	const bare = (fetchedText(flower) ?? "").replace(/@[^@]*@|\/\*[\s\S]*?\*\//g, (all) => all.replace(/[^\n]/g, " "));
	const modules = bare.search(/^[ \t]*#[ \t]*module\b/m);
	const own = modules < 0 ? bare : bare.slice(0, modules);
	const names = own.matchAll(/^[ \t]*#[ \t]*define[ \t]+(\p{L}[\p{L}\p{N}_]*)[ \t]*=/gmu);
	return [...names].map(([, name]) => name).filter((name) => name !== "finalStep");
}
