/**
 * Reads texts of 256 KiB that made a page, a service or the command line hang. tests/patterns.test.ts proves that no pattern backtracks; here
 * each reader gets its worst text. A reader that takes time with the square of the length, or more, takes minutes for one of them, and the
 * run ends by its time limit.
 */
import { expect, it } from "vitest";
import { splitCells, splitRows } from "../../web/src/batch/csv_rows";
import { readVary } from "../../web/src/batch/vary";
import { numberAt, outlineOf, withConstants } from "../../web/src/grammar_editor/outline";
import { findRange } from "../../web/src/grammar_editor/range_words";
import { scan } from "../../web/src/grammar_editor/scan";
import { BUNCH } from "../../web/src/models/bunch/schema";
import { readLine } from "../../web/src/models/flower/design/description";
import { designOf } from "../../web/src/models/flower/design/design";
import { FLOWER } from "../../web/src/models/flower/schema";
import { usesAge, variablesIn } from "../../web/src/models/flower/texts";
import { describeNumber } from "../../web/src/models/flower/ui/number_words";
import type { GrammarPlant } from "../../web/src/models/grammar/grammar_plant";
import { GRAMMAR } from "../../web/src/models/grammar/schema";
import type { GrammarSpecimen } from "../../web/src/models/grammar/specimen";
import { definedNames } from "../../web/src/models/grammar/texts";
import { warningsOf } from "../../web/src/models/grammar/ui/warnings";
import { titleOfText } from "../../web/src/models/grammar/words";
import { withValues } from "../../web/src/models/grammar/written_text";
import { withVolumes, writtenVolumes } from "../../web/src/models/growth/volumes/footprint";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { readNumber } from "../../web/src/specimen/read_values";
import { restore } from "../../web/src/specimen/restore";
import { symbol } from "../../web/src/ui/symbol";
import { withThousands } from "../../web/src/ui/thousands";

const LONGEST = 256 * 1024;
/** A text of 256 KiB: some words over and over between two others. */
const long = (words: string, before = "", behind = "") =>
	before + words.repeat(Math.ceil((LONGEST - before.length - behind.length) / words.length)) + behind;

const grammarOf = (grammar: string): GrammarSpecimen => ({ ...fromPreset(GRAMMAR), grammar, constants: {} });
const cut = {
	noteMessages: [{ code: "core.grammar.cut_short", args: {}, text: "Cut short." }],
	counts: { steps: 1 },
} as unknown as GrammarPlant;

const COMMENTS = [
	long("1", "#define a 1 /* ", " */\naxiom: F(a)"),
	long(" ", "#define a 1 /* 0..9", "x */\naxiom: F(a)"),
	long("1 ", "#define a 1 /* ", " */\naxiom: F(a)"),
	long("1..", "#define a 1 /* ", " */\naxiom: F(a)"),
	long(", ;", "#define a 1 /* x", "x */\naxiom: F(a)"),
	long("*", "#define a 1 /* ", "x*/\naxiom: F(a)"),
	long(" ", "/*", "*x */\naxiom: F"),
	long("/* ", "", "#define x=1"),
	long("/*/", "#define x=1 ", "\n#axiom"),
	long("@ ", "#axiom\n", "@"),
	long("\n", "", "#role berry"),
	long(" ", "#define", "\naxiom: F"),
	long("#define a 1\n"),
	long("(", "#curve f ", ")"),
	long("(1,1)(", "#curve f "),
	long(" ", "derivation length: 1", "/x\naxiom: F"),
	long("derivation length: 1 /x\n"),
	long("derivation length: ", "axiom: F\n"),
	long('"bud', "#material ", "\n"),
	long("@organ petal count=5@\n"),
	long("@organ petal"),
];

it.each(COMMENTS.map((text) => [text.slice(0, 30), text]))("grammars: %j and so on", async (_, text) => {
	const outline = outlineOf(text);
	expect(numberAt(outline.pieces, text.length)).toBeUndefined();
	expect(scan(text).length).toBe(outline.pieces.length);
	expect(titleOfText(text)).not.toBe("");
	expect(warningsOf(cut, grammarOf(text)).length).toBeGreaterThan(0);
	expect(withValues(text, { constants: { a: 2 }, steps: 3 })).not.toBe("");
	await definedNames(grammarOf(text));
	await variablesIn({ grammar: text, preset: "tulip" });
	usesAge({ grammar: text, preset: "tulip" });
	expect(designOf(text)).toBeUndefined();
	describeNumber(text, "x");
	for (const schema of [BUNCH, FLOWER, GRAMMAR]) restore(schema as typeof BUNCH, { grammar: text });
});

it("many definitions get their values in one pass", () => {
	const text = Array.from({ length: 15_000 }, (_, i) => `#define n${i} ${i}\n`).join("");
	const values = Object.fromEntries(Array.from({ length: 15_000 }, (_, i) => [`n${i}`, i + 1]));
	expect(withConstants(text, values)).toBe(text.replace(/ \d+\n/g, (number) => ` ${Number(number) + 1}\n`));
});

it.each([
	long(",", "footprint -> GrowVol("),
	long("footprint->GrowVol("),
	long(" ", "footprint -> GrowVol(1)", "x"),
	long("footprint -> GrowVol(1)\n"),
	long("(", "footprint -> GrowVol("),
	long(" ", "tree"),
])("footprints of growth", (text) => {
	expect(writtenVolumes(text)).toBeUndefined();
	expect(withVolumes(text, [])).toContain("footprint -> ");
});

it("numbers, ranges, names and rows", () => {
	expect(readNumber(long("1", "", "x"))).toBeUndefined();
	expect(readNumber(long("1", "1.", "e"))).toBeUndefined();
	for (const words of ["1", "1 ", "-", "..", "1.. x", "1 to", "1 ..x", "to ", "− "])
		expect(findRange(long(words, "", "x"))).toBeUndefined();
	withThousands(long("1", "", ".5"));
	withThousands(long("1,"));
	symbol(long("a", "", "\n"));
	expect(readLine(long("a", "@organ petal "))).toBeUndefined();
	expect(() => readVary(BUNCH, long("a", "", "\n"), fromPreset(BUNCH))).toThrow("Write KEY=FROM..TO");
	expect(() => readVary(BUNCH, long(".", "age=", "\n"), fromPreset(BUNCH))).toThrow();
	for (const row of [long('"'), long('""', '"'), long('"a'), long("a,"), long('",')]) {
		expect(splitRows(row)).toEqual([]);
		splitCells(`${row}\r\n`);
	}
});

it("rows of an unfinished table are left out, and quoted cells may contain separators", () => {
	const rows = ['a,"b ""c"", d",\r\n', '"x\r\ny",,z\r\n'];
	expect(splitRows(`${rows.join("")}broken,"off`)).toEqual(rows);
	expect(rows.map(splitCells)).toEqual([
		["a", 'b "c", d', ""],
		["x\r\ny", "", "z"],
	]);
});
