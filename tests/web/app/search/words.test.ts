import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { isOneTypo, singularOf, tokensOf } from "../../../../web/src/app/search/words";

describe("words", () => {
	it.each([
		["Shepherd’s purse", ["shepherds", "purse"]],
		["L’arbre d'hiver, œillet", ["arbre", "hiver", "oeillet"]],
		["L-system of Gewürz", ["l", "system", "of", "gewurz"]],
		["Table 1, σ1,1(k; 2)", ["§table:1", "σ1", "1", "k", "2"]],
		["Fig. 15(a) and figures 1.24 b", ["§figure:15a", "§figure:1.24b", "and"]],
		["figure 4 of a paper, figs", ["§figure:4", "of", "a", "paper", "figs"]],
		["tableau 2", ["§table:2"]],
		["config 3", ["config", "3"]],
	])("of %j are %j", (text, tokens) => expect(tokensOf(text)).toEqual(tokens));

	it("of a part of a figure are those of the whole figure, too, if it is indexed", () => {
		expect(tokensOf("fig. 15a", true)).toEqual(["§figure:15a", "§figure:15"]);
	});

	it.each([
		["trees", "tree"],
		["cherries", "cherry"],
		["leaves", "leaf"],
		["branches", "branch"],
		["branches", "branche"],
		["bushes", "bush"],
		["boxes", "box"],
		["grasses", "grass"],
		["crocuses", "crocus"],
		["bouleaux", "bouleau"],
		["vegetaux", "vegetal"],
		["orties", "ortie"],
		["olives", "olive"],
		["roses", "rose"],
		["species", "species"],
	])("%s and %s are the same in the singular", (plural, singular) =>
		expect(singularOf(plural)).toBe(singularOf(singular)),
	);

	it.each(["grass", "cactus", "phyllotaxis", "figs".slice(0, 3), "oak", "1990s"])("%s stays as it is", (word) =>
		expect(singularOf(word)).toBe(word === "1990s" ? "1990" : word),
	);
});

describe("a typo", () => {
	it.each([
		["oak", "oaks"],
		["oak", "ok"],
		["oak", "oat"],
		["oak", "aok"],
		["rose", "rsoe"],
	])("makes %s of %s", (a, b) => {
		expect(isOneTypo(a, b)).toBe(true);
		expect(isOneTypo(b, a)).toBe(true);
	});

	it.each([
		["oak", "oak"],
		["oak", "kao"],
		["rose", "orse "],
		["rose", "sore"],
		["tulip", "tulipes"],
	])("alone does not make %s of %s", (a, b) => expect(isOneTypo(a, b)).toBe(false));

	it("is one edit, as the matrix of Damerau and Levenshtein has it", () => {
		const word = fc.string({ unit: fc.constantFrom("a", "b", "c"), maxLength: 6 });
		fc.assert(fc.property(word, word, (a, b) => isOneTypo(a, b) === (distance(a, b) === 1)));
	});
});

/** The distance of two words by optimal string alignment. */
function distance(a: string, b: string): number {
	const rows = Array.from({ length: a.length + 1 }, (_, i) =>
		Array.from({ length: b.length + 1 }, (_, j) => (i === 0 ? j : j === 0 ? i : 0)),
	);
	for (let i = 1; i <= a.length; i++) {
		for (let j = 1; j <= b.length; j++) {
			const replaced = rows[i - 1][j - 1] + Number(a[i - 1] !== b[j - 1]);
			rows[i][j] = Math.min(rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced);
			const isExchange = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
			if (isExchange) rows[i][j] = Math.min(rows[i][j], rows[i - 2][j - 2] + 1);
		}
	}
	return rows[a.length][b.length];
}
