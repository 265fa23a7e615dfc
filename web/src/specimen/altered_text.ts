/** Whether a text is another one altered, as handles, gestures and sliders alter it, or one of somebody's own. */

const NUMBER = /\d+(?:\.\d+)?|\.\d+/g;
/** Of the lines of what it comes of so many are still there. */
const SHARE = 0.5;

/** The last one: titles are asked for at every frame of a drag. */
let last: { readonly text: string; readonly from: string; readonly comes: boolean } | undefined;

/** Whether most lines of `from` stand in a text, whatever their numbers. */
export function comesOf(text: string, from: string): boolean {
	if (last?.text === text && last.from === from) return last.comes;
	const own = new Set(linesOf(text));
	const lines = linesOf(from);
	const comes = lines.filter((line) => own.has(line)).length > SHARE * lines.length;
	last = { text, from, comes };
	return comes;
}

const linesOf = (text: string): string[] =>
	text
		.split("\n")
		.map((line) => line.replace(NUMBER, "0").replace(/\s+/g, ""))
		.filter((line) => line !== "");
