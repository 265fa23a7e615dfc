/** Distinguishes a text that was altered by handles, gestures and sliders from a text of the user's own. */

const NUMBER = /\d+(?:\.\d+)?|\.\d+/g;
/** Share of the original's lines that an altered text still contains. */
const SHARE = 0.5;

/** The last result: titles are computed at every frame of a drag. */
let last: { readonly text: string; readonly from: string; readonly isVariant: boolean } | undefined;

/** Returns whether a text contains most lines of `from`, ignoring numbers. */
export function isVariantOf(text: string, from: string): boolean {
	if (last?.text === text && last.from === from) return last.isVariant;
	const own = new Set(linesOf(text));
	const lines = linesOf(from);
	const isVariant = lines.filter((line) => own.has(line)).length > SHARE * lines.length;
	last = { text, from, isVariant };
	return isVariant;
}

/** Returns a text's lines that are not empty, without blanks and with 0 for every number. */
const linesOf = (text: string): string[] =>
	text
		.split("\n")
		.map((line) => line.replace(NUMBER, "0").replace(/\s+/g, ""))
		.filter((line) => line !== "");
