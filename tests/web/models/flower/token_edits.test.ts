import { describe, expect, it } from "vitest";
import { rangeFor, statedRange, within } from "../../../../web/src/models/flower/ui/number_range";
import { numberGroupsOf } from "../../../../web/src/models/flower/ui/token_edits";

const TEXT = `#define length=320 @ of the stem @
#define STEM(12,0,-3.5,0,20,7,length/40,1)
#axiom: STEM
STEM{}{step<3}{} -> STEM[STEM(,<2>,math.random(-1,1),,<length/16>,7,7,)]_{E}
STEM{}{step==3}{} -> STEM[&PETAL(,-6,,,,,,){len=66; n=2*3}]_{C1,C5}
#module PETAL
#define len=10
#define half=5/2
#define STEM(4,1,0,0,0,1,2,3,4)
#axiom: STEM
STEM -> STEM[STEM(,,9)]_{E}
`;

const named = (origin: Parameters<typeof numberGroupsOf>[1]) =>
	Object.fromEntries(
		numberGroupsOf(TEXT, origin).map(({ title, tokens }) => [
			title,
			tokens.map(({ name, from, to, text }) => {
				expect(TEXT.slice(from, to).replace(/\s/g, "")).toBe(text);
				return `${name} ${text}`;
			}),
		]),
	);

/** The same as lines, each number at its position in the text. */
const linesOf = (text: string, origin: Parameters<typeof numberGroupsOf>[1]) =>
	numberGroupsOf(text, origin).map(({ title, tokens }) => {
		for (const { from, to, text: written } of tokens) expect(text.slice(from, to)).toBe(written);
		return `${title}: ${tokens.map(({ name, text: written }) => `${name} ${written}`).join(", ")}`;
	});

describe("numbers of a text that define a volume", () => {
	it("is figures of its definition, of where it grows, and of variables; no sums", () => {
		expect(named({ label: "STEM", module: 0, line: 4, call: 0 })).toEqual({
			"Every STEM": ["N 12", "atx 0", "aty -3.5", "atz 0", "H 20", "L 7", "m 1"],
			"Grown by line 4": ["atx 2", "L 7", "W 7"],
			"The whole flower": ["length 320"],
		});
	});

	it("is of its module where names are the same, and of how that is called", () => {
		expect(named({ label: "STEM", module: 1, line: 11, call: 5 })).toEqual({
			"Every STEM": ["N 4", "T 1", "atx 0", "aty 0", "atz 0", "H 1", "L 2", "W 3", "m 4"],
			"Grown by line 11": ["atx 9"],
			"Call of PETAL on line 5": ["atx -6", "len 66"],
		});
	});

	it("excludes a definition's numbers that every production overrides", () => {
		const text = (more: string) => `#define STEM(4,0,0,0,9,3,3,1)
#define LOBE(4,0,0,0,1,2,3,4)
#axiom: STEM
STEM -> STEM[LOBE(,5,,,7,,W,)]_{C1}
STEM{}{step<2}{} -> STEM[STEM]_{E}
LOBE -> LOBE[LOBE(,,,,,8,,)]_{E}
${more}`;
		const lobe = (more = "") => linesOf(text(more), { label: "LOBE", module: 0, line: 4, call: 0 })[0];
		// On a predecessor of the same label an empty entry takes the predecessor's value, never the definition's.
		expect(lobe()).toBe("Every LOBE: N 4, aty 0, atz 0, L 2, m 4");
		expect(lobe("STEM -> STEM[LOBE(,,,,,,W,)]_{C2}\n")).toBe("Every LOBE: N 4, atx 0, aty 0, atz 0, H 1, L 2, m 4");
		const all = "Every LOBE: N 4, atx 0, aty 0, atz 0, H 1, L 2, W 3, m 4";
		expect(lobe("STEM -> STEM[LOBE]_{C2}\n")).toBe(all);
		expect(lobe("STEM -> LOBE\n")).toBe(all);
		expect(lobe("STEM -E-> STEM LOBE\n")).toBe(all);
	});

	it("is no variable that every call of a module sets, and those of the text that its call is worked out from", () => {
		const text = `#define size=2
#define other=3
#axiom: STEM
STEM -> STEM[&PETAL{len=size*30; wide=9}]_{C1}[&PETAL{len=20}]_{C3}
#module PETAL
#define len=10
#define wide=5
#define A(4,0,0,0,1,2,3,4)
#axiom: A
`;
		const groups = numberGroupsOf(text, { label: "A", module: 1, line: 9, call: 4 });
		const titled = (title: string) => groups.find((each) => each.title === title)?.tokens.map(({ name }) => name);
		expect(titled("Call of PETAL on line 4, 1 of 2")).toEqual(["wide"]);
		expect(titled("Call of PETAL on line 4, 2 of 2")).toEqual(["len"]);
		expect(titled("Every PETAL")).toEqual(["wide"]);
		expect(titled("The whole flower")).toEqual(["size"]);
	});

	it("is all that it may come from, each by its place, where one line grows or calls one thing twice", () => {
		const text = `#define A(4,1,0,0,0,1,1,1,1)
#axiom: A
A -> A[A(,,5)]_{E}[A(,,7)]_{C1}
A -> A[&M{n=4}]_{C1}[&M{n=5}]_{C2}
A -> A[&A(,7)]_{C3}
#module M
#define n=1
#define B(4)
#axiom: B
#module A
#define B(4)
#axiom: B
`;
		expect(linesOf(text, { label: "A", module: 0, line: 3, call: 0 }).slice(1)).toEqual([
			"Grown by line 3, 1 of 2: atx 5",
			"Grown by line 3, 2 of 2: atx 7",
		]);
		expect(linesOf(text, { label: "B", module: 1, line: 0, call: 4 }).slice(1)).toEqual([
			"Call of M on line 4, 1 of 2: n 4",
			"Call of M on line 4, 2 of 2: n 5",
		]);
		expect(linesOf(text, { label: "A", module: 0, line: 5, call: 0 })).toHaveLength(1);
	});

	it("lists what may have grown on its face if one line grows or calls one name twice", () => {
		const text = `#define A(8,1,0,0,0,1,1,1,1)
#axiom: A
A -> A[A(,,5)]_{E}[A(,,7)]C1,C2
A -> A[&M(,,3){n=4}]_{C1, C4}[&M{n=5}]_{C2,C(3)}[&M{n=6}]_{O}
#module M
#define n=1
#define B(4)
#axiom: B
`;
		const grown = (face: number) => linesOf(text, { label: "A", module: 0, line: 3, call: 0, face }).slice(1);
		expect(grown(1)).toEqual(["Grown by line 3: atx 5"]);
		expect(grown(3)).toEqual(["Grown by line 3: atx 7"]);
		expect(grown(9)).toHaveLength(2);
		const called = (foot: number) =>
			linesOf(text, { label: "B", module: 1, line: 0, call: 4, moduleFace: foot }).slice(1);
		expect(called(0)).toEqual(["Call of M on line 4, 1 of 2: n 5", "Call of M on line 4, 2 of 2: n 6"]);
		expect(called(2)[0]).toBe("Call of M on line 4, 1 of 2: aty 3, n 4");
		expect(called(4)).toEqual(["Call of M on line 4: n 5"]);
	});

	it("passes over the number that is too many of ten, as the core does", () => {
		const text = `#define A(4,1,0,0,0,0,5,0.5,1,4)
#axiom: A
A -> A[A(,,2,3,,,7,8)]_{E}[A(,,9,,,,,,,6)]_{C1}`;
		expect(linesOf(text, { label: "A", module: 0, line: 3, call: 0 })).toEqual([
			"Every A: N 4, T 1, atx 0, aty 0, atz 0, H 5, L 0.5, W 1, m 4",
			"Grown by line 3, 1 of 2: aty 2, atz 3, W 7, m 8",
			"Grown by line 3, 2 of 2: atx 9, m 6",
		]);
	});

	it("uses the form of the module's axiom in calls", () => {
		const text = `#define S(4)
#axiom: S
S -> S[&M(,5)]_{E}
#module M
#define A(4,1,0,0,0,1,1,1,1)
#define B(4,0,0,0,1,1,1,1)
#axiom: B
B -> B[A]_{E}`;
		expect(linesOf(text, { label: "A", module: 1, line: 8, call: 3 })).toContain("Call of M on line 3: atx 5");
	});

	it("is found behind a sign and a blank, too, or a comment", () => {
		const text = `# define A(4,1,0,0,0,1,1,1,1)
#@ of the stem @ define k=2
#\tmodule M
# axiom: A
A -> A[A(,,5)]_{E}
`;
		expect(linesOf(text, { label: "A", module: 0, line: 5, call: 0 })).toEqual([
			"Every A: N 4, T 1, atx 0, aty 0, atz 0, H 1, L 1, W 1, m 1",
			"Grown by line 5: atx 5",
			"The whole flower: k 2",
		]);
	});

	it("is empty for names that the text does not have", () => {
		expect(numberGroupsOf("", { label: "A", module: 3, line: 9, call: 9 })).toEqual([]);
		expect(numberGroupsOf("#define A(", { label: "A", module: 0, line: 1, call: 0 })).toEqual([]);
	});
});

describe("how far a figure is slid", () => {
	it("depends on the number's name", () => {
		expect(rangeFor("N", 6)).toMatchObject({ min: 3, max: 24, step: 1 });
		expect(rangeFor("atx", -20)).toMatchObject({ min: -90, max: 90, step: 1 });
		expect(rangeFor("len", 66)).toMatchObject({ min: 1, max: 132, step: 1 });
		expect(rangeFor("t", 0.5)).toMatchObject({ min: 0, max: 1, step: 0.01 });
		expect(rangeFor("x", -1.5).min).toBe(-3);
		expect(rangeFor("t", 0.5).written(0.12345)).toBe("0.12");
		expect(rangeFor("t", 0.5).written(7)).toBe("1.00");
	});

	it("is the range in the text, or of its slider among the constants", () => {
		const text = "#define sides=12 /* 3 … 24 step 3, of the stem */\n#define A(sides,5)\n#axiom: A\n";
		const [whole] = numberGroupsOf(text, { label: "A", module: 0, line: 0, call: 0 }).filter(
			({ title }) => title !== "Every A",
		);
		expect(whole.tokens.map(({ range }) => range && statedRange(range))).toMatchObject([{ min: 3, max: 24, step: 3 }]);
		expect(statedRange({ min: 0, max: 1, step: 0.1 }).written(0.72)).toBe("0.7");
	});

	it("is constant while the value is within it", () => {
		const range = rangeFor("H", 10);
		expect(within(range, 19)).toBe(range);
		expect(within(range, 21)).toBeUndefined();
	});
});
