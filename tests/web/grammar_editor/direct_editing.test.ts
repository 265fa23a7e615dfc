import { describe, expect, it } from "vitest";
import { complaintOf, takenOf } from "../../../web/src/grammar_editor/constants";
import { added, frameOf, inText, moved, removed, valueAt } from "../../../web/src/grammar_editor/curve";
import { difference } from "../../../web/src/grammar_editor/difference";
import { problemsOf, sameProblems } from "../../../web/src/grammar_editor/reported_problems";
import { reach, stepped } from "../../../web/src/grammar_editor/scrub";
import { type GrammarSource, withText } from "../../../web/src/grammar_editor/source";
import type { Message } from "../../../web/src/locale/texts";
import { specimenFromPreset } from "../bunch";

const number = (text: string) => ({ text, value: Number(text) });

describe("dragged numbers", () => {
	it("change by their last digit, and keep their decimals", () => {
		expect(stepped(number("60"), 5)).toBe("65");
		expect(stepped(number("0.50"), -3)).toBe("0.47");
		expect(stepped(number("1.5"), 0.1)).toBe("1.51");
		expect(stepped(number("2"), -4)).toBe("-2");
		expect(stepped(number("-0.1"), 1)).toBe("0.0");
		expect(stepped(number("1e2"), 1)).toBe("101");
	});

	it("take ten steps with Shift and tenths with Control or Command", () => {
		const keys = { shiftKey: false, ctrlKey: false, metaKey: false };
		expect(
			[keys, { ...keys, shiftKey: true }, { ...keys, ctrlKey: true }, { ...keys, metaKey: true }].map(reach),
		).toEqual([1, 10, 0.1, 0.1]);
	});
});

describe("an edited curve", () => {
	const points = [
		[0, 0],
		[0.5, 0.5],
		[1, 1],
	] as const;
	const frame = frameOf(points);

	it("keeps its points in order and in the frame", () => {
		expect(moved(points, 1, [2, 3], frame)[1]).toEqual([0.99, 1]);
		expect(moved(points, 0, [0.9, -1], frame)[0]).toEqual([0.49, 0]);
	});

	it("adds a point only in a gap, and removes points down to two", () => {
		expect(added(points, [0.25, 0.7], frame)).toHaveLength(4);
		expect(added(points, [0.25, 0.7], frame)[1]).toEqual([0.25, 0.7]);
		expect(added(points, [0.501, 0.7], frame)).toBe(points);
		expect(removed(points, 1)).toHaveLength(2);
		expect(removed(points.slice(1), 0)).toHaveLength(2);
	});

	it("is formatted as in a text", () => {
		expect(inText([[0, 0], [1 / 3, -0.0001], [1, 1]], frame)).toBe("(0, 0) (0.33, 0) (1, 1)"); // biome-ignore format: a point each
	});

	it("interpolates its points without overshoot, and is constant outside", () => {
		const hill = [
			[0, 0],
			[0.2, 1],
			[1, 0.4],
		] as const;
		for (const [x, y] of hill) expect(valueAt(hill, x)).toBeCloseTo(y, 12);
		for (let x = -0.5; x < 1.5; x += 0.01) {
			expect(valueAt(hill, x)).toBeGreaterThanOrEqual(0);
			expect(valueAt(hill, x)).toBeLessThanOrEqual(1 + 1e-12);
		}
		expect(valueAt(hill, 7)).toBe(0.4);
	});
});

describe("the difference of two texts", () => {
	it("is a single stretch", () => {
		expect(difference("abc", "abc")).toBeUndefined();
		expect(difference("aXc", "abbc")).toEqual({ from: 1, to: 2, insert: "bb" });
		expect(difference("aa", "aaa")).toEqual({ from: 2, to: 2, insert: "a" });
	});

	it("does not count as the document's own text if it equals the built-in one", () => {
		const source: GrammarSource = { plantName: "bunch", group: "branching", builtIn: () => "axiom: F" };
		const specimen = specimenFromPreset("long-conical");
		expect(withText(source, specimen, "axiom: F F")).toEqual({ details: { grammar: "axiom: F F" } });
		expect(withText(source, specimen, "axiom: F")).toEqual({ details: { grammar: undefined } });
		expect(withText(source, specimen, undefined)).toEqual({ details: { grammar: undefined } });
	});
});

describe("a number typed for a constant", () => {
	const number = (value: number) => ({ text: String(value), value });

	it("is clamped to the range of links, with a message", () => {
		expect([3, 2e9, -2e9].map(takenOf)).toEqual([3, 1e9, -1e9]);
		expect(complaintOf("length", "3", 3, number(3))).toBeUndefined();
		expect(complaintOf("length", "2e9", 2e9, number(1e9))).toBe(
			"length: 2000000000 was changed to 1000000000. -1000000000 … 1000000000.",
		);
		expect(complaintOf("length", "long", Number.NaN, number(3))).toBe("“long” is not a number. length is still 3.");
	});
});

describe("problems reported by the core", () => {
	const notes: Message[] = [
		{
			code: "core.expression.at_line_and_column",
			args: { line: 3, column: 5, problem: "F1 is one symbol." },
			text: "Line 3, column 5: F1 is one symbol.",
		},
		{ code: "core.bunch.no_room", args: { count: 4 }, text: "4 pedicels found no room." },
	];

	it("are the fault, or else the remarks with a place", () => {
		expect(problemsOf(undefined, notes)).toEqual([
			{ severity: "remark", line: 3, column: 5, message: "F1 is one symbol." },
		]);
		const fault = { message: "There is no x.", line: 2, column: 1 };
		expect(problemsOf(fault, notes)).toEqual([{ severity: "error", ...fault }]);
		expect(problemsOf({ ...fault, line: 0 }, notes)).toEqual([]);
	});
});

it("are equal if place, severity and message are equal", () => {
	const remark = { severity: "remark", line: 3, column: 2, message: "odd" } as const;
	expect(sameProblems([remark], [{ ...remark }])).toBe(true);
	expect(sameProblems([remark], [])).toBe(false);
	for (const change of [{ line: 4 }, { column: 1 }, { severity: "error" as const }, { message: "bad" }])
		expect(sameProblems([remark], [{ ...remark, ...change }])).toBe(false);
});
