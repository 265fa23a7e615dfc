import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { choose, isEdited, madeAnew } from "../../../../../web/src/models/flower/design/choose";
import { described } from "../../../../../web/src/models/flower/design/description";
import { assembled, type Design, describedIn, designOf } from "../../../../../web/src/models/flower/design/design";
import { merged } from "../../../../../web/src/models/flower/design/merge";

const words: fc.Arbitrary<string[]> = fc.array(fc.constantFrom("a", "b", "c", "d"), { maxLength: 8 });

describe("two changes of a text", () => {
	it("result in the one change, if the other changed nothing", () => {
		fc.assert(
			fc.property(words, words, (base, changed) => {
				expect(merged(base, base, changed)).toMatchObject({ lines: changed, retained: changed, lost: [] });
				expect(merged(base, changed, base)).toMatchObject({ lines: changed, retained: changed, lost: [] });
				expect(merged(base, changed, changed)).toMatchObject({ lines: changed, lost: [] });
			}),
		);
	});

	it("are both there where they are in different places", () => {
		const lines = [..."abcdefgh"];
		const [mine, made] = [[..."abXcdefgh"], [..."abcdefYh"]];
		expect(merged(lines, mine, made)).toEqual({ lines: [..."abXcdefYh"], retained: [..."abXcdefYh"], lost: [] });
	});

	it("result in the choice and the edits, or report lost lines", () => {
		fc.assert(
			fc.property(words, words, words, (base, mine, made) => {
				const { lines, lost, retained } = merged(base, mine, made);
				const added = (to: readonly string[]) => to.filter((line) => !base.includes(line));
				expect(lines).toEqual(expect.arrayContaining(added(made)));
				expect([...lines, ...lost]).toEqual(expect.arrayContaining(added(mine)));
				expect(retained).toEqual(expect.arrayContaining(added(mine)));
			}),
		);
	});

	it("are both there where they are in neighbouring lines", () => {
		const base = ["#define a=1", "#define b=2", "#define A(4)", "#material 4 petal", "A -> A[A]_{E}", "A -> A[B]_{E}"];
		const made = ["#define a=9", "#define b=2", "#define A(9)", "#material 4 leaf", "A -> A[A]_{C9}", "A -> A[B]_{E}"];
		const mine = [base[0], "/* Mine */", "#define b=7", base[2], "#material 4 sepal", base[4], "A -> A[B]_{C7}"];
		const both = ["#define a=9", "/* Mine */", "#define b=7", "#define A(9)", "", "A -> A[A]_{C9}", "A -> A[B]_{C7}"];
		const lost = "#material 4 sepal";
		expect(merged(base, mine, made)).toEqual({
			lines: both.with(4, "#material 4 leaf"),
			retained: both.with(4, lost),
			lost: [lost],
		});
	});

	it("are both retained in lines of one name, however many lines are around them", () => {
		const base = ["#define a=1", "#define b=2", "#define c=3"];
		const mine = ["#define a=1", "/* Mine */", "#define b=7", "#define c=3"];
		const lines = ["#define a=9", "/* Mine */", "#define b=7"];
		expect(merged(base, mine, ["#define a=9", "#define b=2"])).toEqual({ lines, retained: lines, lost: [] });
	});

	it("are both there where the one puts lines in or out and the other changes the lines beside", () => {
		const base = ["A -> A[A]_{E}", "A -> A[B]_{E}"];
		const made = ["A -> A[A]_{C1}", "A -> A[B]_{C1}"];
		const more = [base[0], "/* Mine */", base[1]];
		expect(merged(base, more, made)).toMatchObject({ lines: [made[0], "/* Mine */", made[1]], lost: [] });
		expect(merged(base, made, more)).toMatchObject({ lines: [made[0], "/* Mine */", made[1]], lost: [] });
		// Lines that the choice removed do not come back in place of others.
		expect(merged(["a", "b"], ["b", "x"], ["a", "n", "m"])).toMatchObject({ lines: ["a", "n", "m"], lost: ["x"] });
	});

	it("are both there where they are different words of a line, unless there are more or fewer", () => {
		const line = '#material 4 petal "aaaaaa" "bbbbbb" name "a, b"';
		const [mine, made] = [line.replace("aaaaaa", "111111"), line.replace("bbbbbb", "222222")];
		expect(merged([line], [mine], [made]).lines).toEqual(['#material 4 petal "111111" "222222" name "a, b"']);
		const longer = `${mine} light 0.5`;
		expect(merged([line], [longer], [made])).toEqual({ lines: [made], retained: [longer], lost: [longer] });
	});

	it("conflict in one place: the choice wins, and lost lines are reported and can be retained", () => {
		const { lines, retained, lost } = merged([..."abc"], [..."aXc"], [..."aYc"]);
		expect([lines, retained, lost]).toEqual([[..."aYc"], [..."aXc"], ["X"]]);
		// Lines deleted by hand that the choice changed.
		expect(merged([..."abc"], [..."ac"], [..."aYc"])).toEqual({ lines: [..."aYc"], retained: [..."ac"], lost: ["b"] });
	});
});

describe("changes of a text that is longer than anyone writes", () => {
	const MANY = 100_000;
	const numbered = (name: string) => Array.from({ length: MANY }, (_, i) => `${name} ${i}`);

	it("are both there where the text begins and ends the same", () => {
		const base = numbered("line");
		const mine = base.toSpliced(50_000, 0, ...["mine", "mine too"]);
		const made = [...base.slice(0, -1), "made"];
		const { lines, retained, lost } = merged(base, mine, made);
		expect([lines.length, retained.length, lost]).toEqual([MANY + 2, MANY + 2, []]);
		expect([lines[50_000], lines[50_002], lines.at(-1)]).toEqual(["mine", "line 50000", "made"]);
	});

	it("without a common line are merged separately, and lost lines are reported", () => {
		const mine = ["a", ...numbered("mine"), "z"];
		const { lines, retained, lost } = merged(["a", ...numbered("base"), "z"], mine, ["a", ...numbered("made"), "z"]);
		expect([lines.length, retained.length, lost.length]).toEqual([MANY + 2, MANY + 2, MANY]);
		expect([lines[1], retained[1], lines.at(-1)]).toEqual(["made 0", "mine 0", "z"]);
	});
});

const designed = (text: string): Design => {
	const design = designOf(text);
	if (!design) throw new Error("no design");
	return design;
};

describe("a choice", () => {
	it("rewrites its organ's section alone", () => {
		const before = designed(assembled());
		const petal = described(describedIn(before, "petal"), { count: 7, outline: "cordate" });
		const { text, lost } = choose(before, petal);
		expect(lost).toEqual([]);
		expect(text).toBe(assembled([petal]));
		const after = designed(text);
		for (const [i, { description, text: section }] of before.sections.entries())
			if (description.organ !== "petal") expect(after.sections[i].text).toBe(section);
	});

	it("leaves what was edited elsewhere in the section", () => {
		const mine = assembled().replace("#define JOINT(4,", "#define EXTRA=3\n#define JOINT(4,");
		const design = designed(mine);
		expect(design.sections.filter(isEdited).map(({ description }) => description.organ)).toEqual(["stamen"]);
		const { text, lost } = choose(design, described(describedIn(design, "stamen"), { length: 40, count: 7 }));
		expect(text).toContain("#define EXTRA=3");
		expect(text).toContain("#define long=40*");
		expect(lost).toEqual([]);
		expect(madeAnew(designed(text), "stamen")).toBe(
			assembled([described(describedIn(design, "stamen"), { length: 40, count: 7 })]),
		);
	});

	it.each([
		["stem", /#define bend=0 /, "#define bend=3.3 ", { length: 200 }],
		["stem", /#define thick=.*/, "#define thick=7", { length: 200, section: "square" }],
		["petal", /(?<=#module PETAL[^@]*)#define cup=.*/, "#define cup=33", { bend: 10 }],
		["petal", /(?<=#module PETAL[^@]*)#define wide=.*/, "#define wide=77", { length: 44 }],
		["petal", /#material 14 petal "\w+"/, '#material 14 petal "123456"', { tip: "ff0000" }],
		["pistil", /LOBE\{\}\{[^}]*\}/, "LOBE{}{step>9}", { count: 5 }],
	] as const)("leaves what was edited in a line beside those it changes: %s, %s", (organ, was, own, values) => {
		const mine = assembled().replace(was, own);
		expect(mine).not.toBe(assembled());
		const design = designed(mine);
		const chosen = described(describedIn(design, organ), values);
		const { text, retained, lost } = choose(design, chosen);
		expect(lost).toEqual([]);
		expect(text).toBe(retained);
		expect(text).toContain(own);
		// Nothing else differs from the choice's result.
		expect(text.replace(own, "")).toBe(assembled([chosen]).replace(was, ""));
	});

	it("reports the lines that it overwrites, and can be applied without losing them", () => {
		const own = "#define long=99";
		const mine = assembled().replace(/#define long=.*/, own);
		const design = designed(mine);
		const chosen = choose(design, described(describedIn(design, "stamen"), { length: 40, anther: 9 }));
		expect(chosen.lost).toContain(own);
		expect(chosen.text).not.toContain(own);
		expect(chosen.retained).toContain(own);
		for (const text of [chosen.text, chosen.retained])
			expect(describedIn(designed(text), "stamen").values).toMatchObject({ length: 40, anther: 9 });
	});

	it("takes a description however it is written", () => {
		const design = designed(
			assembled().replace(/@organ pistil .*@/, "@organ pistil count=5 width=900 nonsense=1 base=red@"),
		);
		expect(describedIn(design, "pistil").values).toMatchObject({ count: 5, width: 30, base: "a3b873", style: 5 });
		// Shorter descriptions, as from before stalks existed, do not count as edited.
		const older = designed(assembled().replace(" stalk=0", ""));
		expect(older.sections.filter(isEdited)).toEqual([]);
	});
});
