/** A translation as a translator: messages by room and key, as generated from a file such as fr.json. */
import type { Translator } from "./locale";

/** A message: its text, or a function of its arguments. */
type Translation = string | ((args: never) => string);

/** Messages by room and key. */
export type Catalogue = Readonly<Record<string, Readonly<Record<string, Translation>>>>;

/** Looks messages up by their codes: the room, a dot and the key. */
export function translatorOf(catalogue: Catalogue): Translator {
	return (code, args) => {
		const dot = code.lastIndexOf(".");
		const entry = catalogue[code.slice(0, dot)]?.[code.slice(dot + 1)];
		return typeof entry === "function" ? entry((args ?? {}) as never) : entry;
	};
}
