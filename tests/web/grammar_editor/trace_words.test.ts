import { describe, expect, it } from "vitest";
import { productionAt } from "../../../web/src/grammar_editor/explain";
import { drawnBy, drawnIn } from "../../../web/src/grammar_editor/lit_parts";
import { outlineOf } from "../../../web/src/grammar_editor/outline";
import { CHART_HEIGHT, stepChart } from "../../../web/src/grammar_editor/step_chart";
import {
	answerInWords,
	chanceInWords,
	countInWords,
	fateOf,
	moduleInWords,
	partsOfModule,
	stepInWords,
} from "../../../web/src/grammar_editor/trace_words";
import { NOT_DRAWN, type TraceEntry } from "../../../web/src/plant/derivation_trace";

const module: TraceEntry = {
	text: "B(3,0.5)",
	parent: 2,
	production: { line: 7, column: 1 },
	fires: { line: 9, column: 1 },
	values: [
		{ name: "n", value: "3" },
		{ name: "t", value: "0.5" },
	],
	chance: { total: 1, weight: 1 / 3, drawn: 0.61234 },
	children: { first: 4, count: 3 },
	last: { first: 9, count: 20 },
};

describe("the description of a module", () => {
	it("splits symbol and parameters, even if the symbol is next to a parenthesis", () => {
		expect(["B(29)", "F", "(", "+(40)", "?E(1,2)", "["].map(partsOfModule)).toEqual([
			["B", "(29)"],
			["F", ""],
			["(", ""],
			["+", "(40)"],
			["?E", "(1,2)"],
			["[", ""],
		]);
	});

	it("names the productions that wrote and rewrite it, with their values, and its result", () => {
		expect(moduleInWords(module, false)).toBe(
			"Produced by line 7. Rewritten in the next step by line 9 with n = 3, t = 0.5. This production was chosen at random, with weight 0.333 of 1 (random number: 0.612). The module is replaced by 3 modules.",
		);
		expect(chanceInWords({ total: 3, weight: 2, drawn: 0 })).toContain("2 of 3");
	});

	it("includes query and response of the environment, and the reason", () => {
		expect(answerInWords({ asked: ["0.1", "2"], answered: ["0.31", "1"] })).toBe("Query: 0.1, 2. Response: 0.31, 1.");
		expect(answerInWords({ asked: [], answered: ["1"] })).toBe("Query: nothing. Response: 1.");
		expect(answerInWords({ answered: ["0", "1", "0"] })).toBe("Received 0, 1, 0.");
		const { fires, production, chance, ...rest } = module;
		const answer = {
			asked: ["1"],
			answered: ["0"],
			words: "There is no room. It overlaps the berry of module #64 by 4.6.",
		};
		expect(moduleInWords({ ...rest, answer }, true)).toBe(
			"Query: 1. Response: 0. There is no room. It overlaps the berry of module 65 by 4.6. The derivation ends here.",
		);
	});

	it("says whether the module is cut, stays, or leaves nothing", () => {
		const none = { first: 3, count: 0 };
		const one = { first: 3, count: 1 };
		const { fires } = module;
		expect(fateOf({ children: none }, false)).toBe("The module is cut off.");
		expect(fateOf({ fires, children: none }, false)).toBe("The module disappears.");
		expect(fateOf({ children: one }, false)).toBe("The module stays as it is.");
		expect(fateOf({ fires, children: one }, false)).toBe("The module is replaced by one module.");
		expect(fateOf({ fires, children: one }, true)).toBe("The derivation ends here.");
	});

	it("lists the productions that do not apply, and why", () => {
		const refusals = [
			{ production: { line: 3, column: 1 }, why: "the condition is false with n = 3" },
			{ production: { line: 5, column: 1 }, why: "the production on line 9 takes precedence" },
		];
		expect(moduleInWords({ ...module, refusals }, false)).toMatch(
			/The module is replaced by 3 modules\. Not rewritten by line 3: the condition is false with n = 3\. Not rewritten by line 5: the production on line 9 takes precedence\.$/,
		);
	});

	it("has the step's number and the total", () => {
		expect([countInWords(1), countInWords(1240)]).toEqual(["1 module", "1,240 modules"]);
		expect([stepInWords(0, 7), stepInWords(3, 7)]).toEqual(["Axiom", "Step 3 of 7"]);
	});
});

describe("parts drawn by modules", () => {
	const marks = { segments: Uint32Array.of(0, 3, 3, NOT_DRAWN, 7), organs: Uint32Array.of(4, 8) };

	it("are found by a span of modules, and modules by a part", () => {
		expect(drawnBy({ first: 3, count: 5 }, marks)).toEqual({ segments: [1, 2, 4], organs: [0] });
		expect(drawnBy({ first: 3, count: 0 }, marks)).toEqual({ segments: [], organs: [] });
		expect(drawnBy({ first: 0, count: NOT_DRAWN }, marks).segments).toEqual([0, 1, 2, 4]);
		expect(drawnIn(marks, { segment: 4 })).toBe(7);
		expect(drawnIn(marks, { organ: 1 })).toBe(8);
		expect(drawnIn(marks, { segment: 3 })).toBeUndefined();
	});
});

describe("the chart of the steps", () => {
	it("is logarithmic, from the first step to the last", () => {
		const heights = [...stepChart([1, 10, 100]).matchAll(/[ML](\S+) ([\d.]+)/g)].map(([, x, y]) => [+x, +y]);
		const [one, ten, hundred] = heights.slice(1, 4);
		expect([one[0], ten[0], hundred[0]]).toEqual([0, 50, 100]);
		expect(one[1] - ten[1]).toBeCloseTo(ten[1] - hundred[1], 1);
		expect(hundred[1]).toBe(0);
		expect(one[1]).toBeLessThan(CHART_HEIGHT);
	});

	it("ends at the given step, is empty for an axiom alone, and is short for any number of steps", () => {
		expect(stepChart([1, 2, 4, 8], 1)).toContain("33.33");
		expect(stepChart([1, 2, 4, 8], 1)).not.toContain("66.67");
		expect(stepChart([5])).toBe("");
		expect(stepChart(new Uint32Array(4097).fill(3)).length).toBeLessThan(8000);
	});
});

describe("the production at a position of the text", () => {
	const text = "#define n 3\naxiom: A\n/* grows */\nA -->\n  F A\nB --> C\n";
	const { pieces } = outlineOf(text);
	const at = (words: string) => {
		const place = text.indexOf(words);
		return productionAt(pieces, place, text.slice(0, place).split("\n").length);
	};

	it("is the production of the line, or of the line that it continues", () => {
		expect([at("A -->"), at("F A"), at("C")]).toEqual([4, 4, 6]);
	});

	it("is undefined in statements and comments", () => {
		expect([at("#define"), at("axiom"), at("grows")]).toEqual([undefined, undefined, undefined]);
	});
});
