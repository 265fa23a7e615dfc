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
export function figureWords(text: string, name: string): string {
	const field = FIELDS.find(([sign]) => sign === name);
	if (field) return field[2] ? `${field[1]}, ${field[2]}` : field[1];
	const defined = new RegExp(`^[ \\t]*#[ \\t]*define[ \\t]+${name}[ \\t]*=[^\\n]*?/\\*([^\\n]*?)\\*/`, "mu").exec(text);
	return defined?.[1].trim() ?? "";
}
