import { describe, expect, it } from "vitest";
import { checkTable } from "../../wasm-core/tools/generate/check_table.mjs";
import { checkMeasures } from "../../wasm-core/tools/generate/measures.mjs";
import { generate } from "../../wasm-core/tools/generate.mjs";

const groups = [{ key: "shape", title: "Shape", help: "" }];
const length = {
	key: "l",
	link: "l",
	label: "Length",
	group: "shape",
	kind: "number",
	min: 29,
	max: 580,
	default: 512,
	step: 1,
	help: "Bunch length.",
	since: 1,
};

function problemsOf(...parameters: object[]): string {
	try {
		checkTable({ groups, parameters }, "t.json");
		return "";
	} catch (error) {
		return (error as Error).message;
	}
}

describe("the parameter table", () => {
	it("may hold a sound parameter", () => expect(problemsOf(length)).toBe(""));

	it.each([
		[{ ...length, default: 600 }, "t.json: l has a default out of its range"],
		[{ ...length, min: 580 }, "t.json: l has an empty range; l has a default out of its range"],
		[{ ...length, group: "form" }, "t.json: l is of the unknown group form"],
		[{ ...length, help: undefined }, "t.json: l has no help"],
		[{ ...length, key: "L" }, "t.json: L has a key that is no lower-case name"],
		[{ ...length, kind: "colour", default: "red", look: true }, "t.json: l has a default that is no colour"],
	])("may not hold %o", (parameter, problems) => expect(problemsOf(parameter)).toBe(problems));

	it("may not say a thing twice", () => {
		expect(problemsOf(length, { ...length, key: "m" })).toBe("t.json: m repeats link l");
		expect(problemsOf({ ...length, slot: 0 }, { ...length, key: "m", slot: 1 })).toBe("");
		expect(problemsOf(length, { ...length, link: "m" })).toBe("t.json: l repeats key l");
	});
});

const weight = {
	key: "weight",
	label: "Weight",
	group: "shape",
	kind: "number",
	unit: "g",
	decimals: 0,
	help: "What it weighs.",
	source: "a balance",
	classes: [
		{ note: 1, at: 100, words: "low" },
		{ note: 9, at: 900, words: "high" },
	],
};

describe("the table of measures", () => {
	const problems = (...measures: object[]) => {
		try {
			checkMeasures({ groups, measures }, "m.json");
			return "";
		} catch (error) {
			return (error as Error).message;
		}
	};

	it("may hold a sound measure", () => expect(problems(weight)).toBe(""));

	it.each([
		[{ ...weight, help: "weight" }, "m.json: weight has help that is no sentence"],
		[{ ...weight, kind: "mass" }, "m.json: weight is of the unknown kind mass"],
		[{ ...weight, group: "form", unit: undefined }, "m.json: weight has no unit; weight is of the unknown group form"],
		[{ ...weight, classes: [...weight.classes].reverse() }, "m.json: weight has classes out of order"],
		[
			{ ...weight, classes: [{ note: 1, from: 0, words: "low" }, weight.classes[1]] },
			"m.json: weight has classes that are not all `at` or all `from`",
		],
		[{ ...weight, kind: "note", classes: undefined }, "m.json: weight is a note without classes"],
	])("may not hold %o", (measure, message) => expect(problems(measure)).toBe(message));

	it("may not name two alike", () => expect(problems(weight, weight)).toBe("m.json: weight stands in it twice"));
});

it("what is generated is what is committed", () => expect(generate({ write: false })).toEqual([]));
