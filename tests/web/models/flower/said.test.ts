import { describe, expect, it } from "vitest";
import { rangeFor, within } from "../../../../web/src/models/flower/tools/figure_range";
import { saidOf } from "../../../../web/src/models/flower/tools/said";

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

const named = (asked: Parameters<typeof saidOf>[1]) =>
	Object.fromEntries(
		saidOf(TEXT, asked).map(({ title, figures }) => [
			title,
			figures.map(({ name, from, to, text }) => {
				expect(TEXT.slice(from, to).replace(/\s/g, "")).toBe(text);
				return `${name} ${text}`;
			}),
		]),
	);

describe("what a text says of a volume", () => {
	it("is figures of its definition, of where it grows, and of variables; no sums", () => {
		expect(named({ label: "STEM", module: 0, line: 4, call: 0 })).toEqual({
			"Every STEM": ["N 12", "atx 0", "aty -3.5", "atz 0", "H 20", "L 7", "m 1"],
			"Where it grows, line 4": ["atx 2", "L 7", "W 7"],
			"The whole flower": ["length 320"],
		});
	});

	it("is of its module where names are the same, and of how that is called", () => {
		expect(named({ label: "STEM", module: 1, line: 11, call: 5 })).toEqual({
			"Every STEM": ["N 4", "T 1", "atx 0", "aty 0", "atz 0", "H 1", "L 2", "W 3", "m 4"],
			"Where it grows, line 11": ["atx 9"],
			"PETAL as it is called, line 5": ["atx -6", "len 66"],
		});
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
		const said = saidOf(text, { label: "A", module: 1, line: 9, call: 4 });
		const titled = (title: string) => said.find((each) => each.title === title)?.figures.map(({ name }) => name);
		expect(titled("PETAL as it is called, line 4")).toEqual(["wide"]);
		expect(titled("Every PETAL")).toEqual(["wide"]);
		expect(titled("The whole flower")).toEqual(["size"]);
	});

	it("is nothing of what the text does not have", () => {
		expect(saidOf("", { label: "A", module: 3, line: 9, call: 9 })).toEqual([]);
		expect(saidOf("#define A(", { label: "A", module: 0, line: 1, call: 0 })).toEqual([]);
	});
});

describe("how far a figure is slid", () => {
	it("is as far as what it says goes", () => {
		expect(rangeFor("N", 6)).toMatchObject({ min: 3, max: 24, step: 1 });
		expect(rangeFor("atx", -20)).toMatchObject({ min: -90, max: 90, step: 1 });
		expect(rangeFor("len", 66)).toMatchObject({ min: 0, max: 132, step: 1 });
		expect(rangeFor("t", 0.5)).toMatchObject({ min: 0, max: 1, step: 0.01 });
		expect(rangeFor("x", -1.5).min).toBe(-3);
		expect(rangeFor("t", 0.5).written(0.12345)).toBe("0.12");
		expect(rangeFor("t", 0.5).written(7)).toBe("1.00");
	});

	it("stays as it is while the hand is within", () => {
		const range = rangeFor("H", 10);
		expect(within(range, 19)).toBe(range);
		expect(within(range, 21)).toBeUndefined();
	});
});
