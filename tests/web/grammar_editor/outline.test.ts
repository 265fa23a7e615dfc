import { describe, expect, it } from "vitest";
import { numberAt, outlineOf, withConstants } from "../../../web/src/grammar_editor/outline";
import { scan } from "../../../web/src/grammar_editor/scan";

const kinds = (text: string) => scan(text).map((piece) => `${piece.kind} ${piece.text}`);
const constant = (text: string) => outlineOf(text).constants[0];

describe("tokens of a grammar's text", () => {
	it("distinguish modules from values", () => {
		expect(kinds("A(i) : i>1 --> F(l*2) [ +(a) A(i-1) ] : 0.5")).toEqual([
			...["symbol A", "mark (", "name i", "mark )", "mark :", "name i", "operator >", "number 1", "arrow -->"],
			...["symbol F", "mark (", "name l", "operator *", "number 2", "mark )", "branch [", "symbol +", "mark ("],
			...["name a", "mark )", "symbol A", "mark (", "name i", "operator -", "number 1", "mark )", "branch ]"],
			...["mark :", "number 0.5"],
		]);
	});

	it("continue with modules on following lines, and across comments", () => {
		const pieces = scan("axiom: A\n  /* two\n lines */ + B\n#define x 2");
		expect(pieces.map(({ kind, text, line }) => [kind, text, line])).toEqual([
			["statement", "axiom:", 1],
			["symbol", "A", 1],
			["comment", "/* two\n lines */", 2],
			["symbol", "+", 3],
			["symbol", "B", 3],
			["statement", "#define", 4],
			["name", "x", 4],
			["number", "2", 4],
		]);
	});

	it("are values in blocks before the arrow and in conditions, and modules in braces behind the arrow", () => {
		expect(kinds("A(x) : {y = x*2;} y>1 --> {.F.}").slice(5)).toEqual([
			...["mark {", "name y", "operator =", "name x", "operator *", "number 2", "mark ;", "mark }"],
			...["name y", "operator >", "number 1", "arrow -->", "symbol {", "symbol .", "symbol F", "symbol .", "symbol }"],
		]);
	});
});

describe("constants", () => {
	it("have their range from the following comment", () => {
		expect(constant("#define x 30 /* 0 … 90 */")).toMatchObject({
			name: "x",
			min: 0,
			max: 90,
			step: 1,
			description: "",
		});
		expect(constant("#define x 30 /* a turn, −10 to 90.5 */")).toMatchObject({
			min: -10,
			max: 90.5,
			description: "a turn",
		});
		expect(constant("#define x 2 /* 0..90 step 5 */")).toMatchObject({ min: 0, max: 90, step: 5 });
	});

	it("extend the range to include their value", () => {
		expect(constant("#define x 120 /* 0 … 90 */")).toMatchObject({ min: 0, max: 120 });
	});

	it("may have an equals sign, and end at a module", () => {
		const { constants } = outlineOf(
			"#define length=-320 /* -450 … 0 mm */\n#define w=2*length\n#module PETAL\n#define K=12",
		);
		expect(constants).toMatchObject([
			{ name: "length", min: -450, max: 0, description: "mm", number: { text: "-320" } },
		]);
	});

	it("have a guessed range without a comment", () => {
		expect(constant("#define alpha_y 60")).toMatchObject({ min: 0, max: 180, step: 1 });
		expect(constant("#define r 0.75")).toMatchObject({ min: 0, max: 1, step: 0.01 });
		expect(constant("#define l 60")).toMatchObject({ min: 0, max: 200, step: 1 });
		expect(constant("#define d -2.5")).toMatchObject({ min: -5, max: 5, step: 0.01, number: { value: -2.5 } });
		expect(constant("#define z 0")).toMatchObject({ min: -10, max: 10 });
	});

	it("must be a single number", () => {
		expect(outlineOf("#define x 2*y\n#define y z\n#define w 2 + 1\n#input m").constants).toEqual([]);
		expect([...outlineOf("#define x 2*y\n#input m[]").names.keys()]).toEqual(["x", "m"]);
	});

	it("are no functions, because a function's body has no single value", () => {
		const text = "#define f(x) 2*x\n#define g(x, y) 3\n#define h(x)\n#define k (2)\naxiom: A";
		const { constants, definitions, names } = outlineOf(text);
		expect(definitions.map(({ name }) => name)).toEqual(["h", "k"]);
		expect(constants).toEqual([]);
		expect(names.get("f")).toBe("#define f(x) 2*x");
		expect(withConstants(text, { f: 7, g: 8 })).toBe(text);
	});

	it("include computed definitions, but no lists, comments or modules", () => {
		const text =
			"#define x 2*y /* z */\n/*\n#define x 7\n*/\n#define w (1 +\n 2)\n#define l[] 1, 2\n#define e\n#module M\n#define m 1";
		const { definitions } = outlineOf(text);
		expect(definitions.map(({ name, from, to }) => [name, text.slice(from, to)])).toEqual([
			["x", "2*y"],
			["w", "(1 +\n 2)"],
		]);
		expect(withConstants("#define f max(2,\naxiom: F", { f: 3 })).toBe("#define f 3\naxiom: F");
	});

	it("can be replaced in the text", () => {
		const text = "#define x 1 /* 0 … 9 */\n#define y -2\naxiom: F(x)";
		expect(withConstants(text, { x: 3.5, y: 40, z: 1 })).toBe("#define x 3.5 /* 0 … 9 */\n#define y 40\naxiom: F(x)");
	});
});

describe("curves", () => {
	it("have points, with their range in the text", () => {
		const text = "#curve taper (0, 0) (0.3, -1) (1, .5) /* x */";
		const [curve] = outlineOf(text).curves;
		expect(curve.points).toEqual([[0, 0], [0.3, -1], [1, 0.5]]); // biome-ignore format: a point each
		expect(text.slice(curve.from, curve.to)).toBe("(0, 0) (0.3, -1) (1, .5)");
	});

	it("are ignored if they are not points", () => {
		expect(outlineOf("#curve a (0, x) (1, 1)\n#curve b (0, 0)\n#curve c").curves).toEqual([]);
	});
});

describe("the number at a position", () => {
	const at = (text: string, place: number) => numberAt(scan(text), place)?.text;

	it("includes its sign, but no operator", () => {
		expect(at("axiom: F(-2.5)", 11)).toBe("-2.5");
		expect(at("axiom: F(-2.5)", 9)).toBe("-2.5");
		expect(at("axiom: F(x-2)", 11)).toBe("2");
		expect(at("axiom: F(3)-(25)", 13)).toBe("25");
		expect(at("#define x -2", 11)).toBe("-2");
	});

	it("is undefined elsewhere", () => {
		expect(at("axiom: F(25)", 7)).toBeUndefined();
		expect(at("axiom: A1 /* 25 */", 8)).toBeUndefined();
		expect(at("axiom: A1 /* 25 */", 14)).toBeUndefined();
	});
});
