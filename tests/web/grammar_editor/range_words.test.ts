import { expect, it } from "vitest";
import { insideComment } from "../../../web/src/grammar_editor/comments";
import { findRange, trimSeparators } from "../../../web/src/grammar_editor/range_words";

it.each([
	["0 … 90", "0", "90", undefined, ""],
	["angle, 0...90", "0", "90", undefined, "angle, "],
	["0..90 step 5 of turning", "0", "90", "5", " of turning"],
	["0 to 90, step .5", "0", "90", ".5", ""],
	["−1 – 1", "−1", "1", undefined, ""],
	["-0.5..1.25", "-0.5", "1.25", undefined, ""],
	["1. .. 2.", "1.", "2.", undefined, ""],
	["in 1998 from 3 to 4", "3", "4", undefined, "in 1998 from "],
	["3 or 4 … 5 steps", "4", "5", undefined, "3 or  steps"],
	["0..9 step wide", "0", "9", undefined, " step wide"],
] as const)("reads %j", (text, low, high, step, description) => {
	expect(findRange(text)).toEqual({ low, high, step, description });
});

it.each(["", "90", "0 tons", "0to9", "from to 9", "0 .. x", "a..b", ". .. ."])("finds no range in %j", (text) =>
	expect(findRange(text)).toBeUndefined(),
);

it("trims separators around a range, and the delimiters of a comment", () => {
	expect(trimSeparators(" ,; turning, of:; ")).toBe("turning, of");
	expect(trimSeparators(" ;,")).toBe("");
	expect(["/* a */", "/** a **/", "/* a", "/**/", "/*/", "/***/"].map(insideComment)).toEqual([
		" a ",
		" a ",
		" a",
		"",
		"",
		"",
	]);
});
