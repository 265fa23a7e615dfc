/** The nine numbers of a volume, and what a figure of a flower's text is, in words. */

/** As the text calls them, what they are and in what they are counted. */
export const FIELDS = [
	["N", "sides", ""],
	["T", "translation", ""],
	["atx", "turn about x", "°"],
	["aty", "turn about y", "°"],
	["atz", "turn about z", "°"],
	["H", "height", "mm"],
	["L", "length", "mm"],
	["W", "width", "mm"],
	["m", "material", ""],
] as const;

/** What a figure is: of a volume's numbers the table's words, of a variable the comment behind its definition; empty where nobody says. */
export function describeNumber(text: string, name: string): string {
	const field = FIELDS.find(([sign]) => sign === name);
	if (field) return field[2] ? `${field[1]}, ${field[2]}` : field[1];
	for (const head of text.matchAll(/^[ \t]*#[ \t]*define[ \t]+([\p{L}\p{N}_]+)[ \t]*=/gmu)) {
		if (head[1] !== name) continue;
		const line = text.slice(head.index + head[0].length).split("\n", 1)[0];
		const from = line.indexOf("/*");
		const to = line.indexOf("*/", from + 2);
		if (from >= 0 && to >= 0) return line.slice(from + 2, to).trim();
	}
	return "";
}
