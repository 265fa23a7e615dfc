/** Words of a text as searches compare them: without case, accents, plural endings and the marks between them. */

/** Begins a token that names a figure or a table, such as "§figure:1.24a"; no word contains it. */
const REFERENCE = "§";

/** "fig. 11", "Figure 15(a)", "figures 1.24 b", "table 1", "tableau 1", in a simplified text. */
const REFERENCES = /(?<!\p{L})(figures?|figs?|tables?|tableaux?)\.?\s*(\d+(?:\.\d+)*)(?:\s?\(?([a-z])(?![\p{L}\d]))?/gu;

/** Articles that French joins to the word after them: "l’arbre". */
const ELISIONS = /(?<!\p{L})(?:[cdjlmnst]|qu)['’](?=\p{L})/gu;

/** Numbers with their parts ("1.24"), and words. */
const WORDS = /\d+(?:\.\d+)*|\p{L}[\p{L}\d]*/gu;

/** Returns the text without case and accents, which people do not type. */
export function plain(text: string): string {
	return text
		.normalize("NFD")
		.replace(/\p{M}/gu, "")
		.toLowerCase()
		.replaceAll("œ", "oe")
		.replaceAll("æ", "ae")
		.replaceAll("ß", "ss");
}

/** Returns the token of a figure or a table from its number, such as "15a". */
export const referenceTo = (kind: "figure" | "table", number: string): string => `${REFERENCE}${kind}:${number}`;

/**
 * Returns the words of a text in order, and the figures and tables that it names: "Fig. 15(a)" has the token of figure
 * 15a, and, where `whole` is set, that of figure 15, too.
 */
export function tokensOf(text: string, whole = false): readonly string[] {
	const references: string[] = [];
	const rest = plain(text).replace(REFERENCES, (_, word: string, number: string, part = "") => {
		const kind = word.startsWith("fig") ? "figure" : "table";
		references.push(referenceTo(kind, number + part));
		if (whole && part !== "") references.push(referenceTo(kind, number));
		return " ";
	});
	const words = rest.replace(ELISIONS, "").replace(/['’]/g, "").match(WORDS) ?? [];
	return [...references, ...words];
}

/** Returns whether a token names a figure or a table, or is the key of a shelf: only the same one matches it. */
export const isExact = (token: string): boolean => token.includes(":");

/** Plurals and singulars that follow no rule below. */
const IRREGULAR: Readonly<Record<string, string>> = {
	leaves: "leaf",
	halves: "half",
	feet: "foot",
	teeth: "tooth",
	fungi: "fungus",
	axes: "axis",
	yeux: "oeil",
};

/**
 * Returns the word without the ending of its plural, in English and French: "cherries" and "cherry" are the same, and
 * so are "branches" and "branch", "bouleaux" and "bouleau".
 */
export function singularOf(word: string): string {
	const irregular = IRREGULAR[word];
	if (irregular !== undefined) return irregular;
	if (word.length < 4 || isExact(word)) return word;
	if (/(ss|us|is)$/.test(word)) return word;
	if (/(us|is|ch|sh|x|ss|z)es?$/.test(word)) return word.replace(/es?$/, "");
	if (/aux$/.test(word)) return word.replace(/([^e])aux$/, "$1al").replace(/x$/, "");
	return word.replace(/ies?$/, "y").replace(/([^s])s$/, "$1");
}

/**
 * Returns whether one letter added, left out, replaced, or exchanged with its neighbour makes one word of the other.
 */
export function isOneTypo(a: string, b: string): boolean {
	const [short, long] = a.length <= b.length ? [a, b] : [b, a];
	if (long.length - short.length > 1 || a === b) return false;
	let from = 0;
	while (from < short.length && short[from] === long[from]) from++;
	if (long.length > short.length) return short.slice(from) === long.slice(from + 1);
	const isExchange = short[from] === long[from + 1] && short[from + 1] === long[from];
	return (
		short.slice(from + 1) === long.slice(from + 1) || (isExchange && short.slice(from + 2) === long.slice(from + 2))
	);
}
