import { expect, it } from "vitest";
import { insideComment } from "../../../web/src/grammar_editor/comments";
import { findRange, trimSeparators, unitIn } from "../../../web/src/grammar_editor/range_words";
import { labelOf } from "../../../web/src/grammar_editor/source";

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

it.each([
	["mm, of the stem", "mm"],
	["degrees a step, of the stem", "°"],
	["metres", "m"],
	["of the flower", ""],
	["mmm", ""],
	["constructor", ""],
	["", ""],
])("reads the unit at the beginning of %j", (description, unit) => expect(unitIn(description)).toBe(unit));

it("labels a constant by its source, else by its name, with a capital if it is a word", () => {
	const label = (name: string) => (name === "bow" ? { label: "Blade bend", unit: "°" } : undefined);
	expect(labelOf({ label }, { name: "bow", unit: "" })).toEqual({ label: "Blade bend", unit: "°" });
	expect(labelOf({ label }, { name: "shrink", unit: "mm" })).toEqual({ label: "Shrink", unit: "mm" });
	for (const name of ["a", "r1", "LA", "lo"]) expect(labelOf({}, { name, unit: "" }).label).toBe(name);
});
