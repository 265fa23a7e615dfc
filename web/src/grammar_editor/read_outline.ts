import type { Dialect } from "./dialect";
import { type GrammarOutline, outlineOf } from "./outline";
import { scan as scanLSystem } from "./scan";

type Scan = Dialect["scan"];

/**
 * Cache of the last outlines, the newest first: of the document's text, of the built-in text, and of the text before a
 * change.
 */
let recent: readonly { readonly text: string; readonly scan: Scan; readonly outline: GrammarOutline }[] = [];
const MAX_RECENT = 3;

/**
 * Returns the outline of a text. Editor, panel and document read the same text after each key; it is scanned once for
 * all of them.
 * @param dialect the language of the text; that of L-systems where absent
 */
export function readOutline(text: string, { scan }: Pick<Dialect, "scan"> = { scan: scanLSystem }): GrammarOutline {
	const known = recent.find((each) => each.scan === scan && each.text === text);
	const read = known ?? { text, scan, outline: outlineOf(text, scan(text)) };
	recent = [read, ...recent.filter((each) => each !== known)].slice(0, MAX_RECENT);
	return read.outline;
}
