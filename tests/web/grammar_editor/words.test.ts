import { readFileSync } from "node:fs";
import { Text } from "@codemirror/state";
import { describe, expect, it, vi } from "vitest";
import { optionsFor } from "../../../web/src/grammar_editor/completion";
import { LSYSTEM } from "../../../web/src/grammar_editor/dialect";
import { explain, formalsAt } from "../../../web/src/grammar_editor/explain";
import { colouredPieces, LONGEST_COLOURED } from "../../../web/src/grammar_editor/highlight";
import { outlineOf } from "../../../web/src/grammar_editor/outline";
import { readOutline } from "../../../web/src/grammar_editor/read_outline";
import { scan } from "../../../web/src/grammar_editor/scan";
import { WORDS } from "../../../web/src/grammar_editor/words.generated";

const named = (kind: string) => WORDS.filter((word) => word.kind === kind).map(({ name }) => name);
const TEXT =
	"#define angle 35 /* a turn */\n#role axis A\naxiom: A(5)\nA(n) : n>0 --> F(angle) [ +(abs(n)) A(n-1) ]\n  B";
/** Returns the completions offered at a mark. */
const offered = (text: string, word = "") => {
	const place = text.indexOf("¦");
	return optionsFor(text.replace("¦", ""), place, word, ["axis", "end"], LSYSTEM).map(({ label }) => label);
};

describe("words of the editor", () => {
	it("are the core's functions, with their arguments", () => {
		const operations = readFileSync("wasm-core/src/expression/operations.hpp", "utf8");
		const listed = /\bfunctions = \{\{([\s\S]*?)\}\};/.exec(operations)?.[1] ?? "";
		const core = [...listed.matchAll(/\{"(\w+)", Op::\w+, (\d)\}/g)].map(([, name, count]) => `${name} ${count}`);
		const ours = WORDS.filter(({ kind }) => kind === "function").map(
			({ name, written }) => `${name} ${written.split(",").length}`,
		);
		expect(core.length).toBeGreaterThan(20);
		expect(ours).toEqual(core);
	});

	it("have unique names", () => {
		for (const kind of ["symbol", "function", "statement"]) {
			expect(new Set(named(kind)).size).toBe(named(kind).length);
			expect(named(kind).length).toBeGreaterThan(7);
		}
	});
});

describe("a single key press", () => {
	it("scans the text once, for the editor, the panel, the document and completion", () => {
		const scans = vi.fn(scan);
		const language = { ...LSYSTEM, scan: scans };
		const text = `${TEXT}\nB --> an`;
		const outline = readOutline(text, language);
		expect(readOutline(`${TEXT}\nB --> ${"an"}`, language)).toBe(outline);
		optionsFor(text, text.length, "an", [], language);
		expect(scans).toHaveBeenCalledTimes(1);
		// Outlines of the text before it and of the built-in text are still cached.
		readOutline("axiom: F", language);
		readOutline("axiom: A", language);
		expect(readOutline(text, language)).toBe(outline);
		expect(scans).toHaveBeenCalledTimes(3);
	});

	it("does not offer the name that is being typed", () => {
		expect(offered("axiom: A¦", "A")).not.toContain("A");
		expect(offered(`${TEXT} A¦`, "A")).toContain("A");
		expect(offered("#define one 1\naxiom: F(on¦)", "on")).toEqual(expect.arrayContaining(["one"]));
		expect(offered("#define one 1\naxiom: F(on¦)", "on")).not.toContain("on");
	});
});

describe("colours", () => {
	const ranges = [{ from: 0, to: 60_000 }];
	const colouredIn = (text: string) => colouredPieces(scan(text), Text.of(text.split("\n")), ranges);

	it("are those of visible tokens, except in long lines", () => {
		const long = "F".repeat(LONGEST_COLOURED);
		const text = `axiom: F\nA --> ${long}\nB --> F G`;
		expect(colouredIn(text).map((piece) => piece.text)).toEqual(["axiom:", "F", "B", "-->", "F", "G"]);
		const [first] = colouredPieces(scan(text), Text.of(text.split("\n")), [{ from: 7, to: 8 }]);
		expect(first).toMatchObject({ text: "F", from: 7 });
		expect(colouredIn(`/* ${long}\n*/ F`).map((piece) => piece.text)).toEqual(["F"]);
	});
});

describe("help", () => {
	const at = (words: string) => explain(outlineOf(TEXT), TEXT.indexOf(words), LSYSTEM.words);

	it("explains the word at a position", () => {
		expect(at("F(")).toMatchObject({ written: "F(s)", help: expect.stringContaining("draw a line") });
		expect(at("angle)")?.help).toBe("#define angle 35");
		expect(at("n-1")?.help).toContain("parameter");
		expect(at("abs")?.written).toBe("abs(x)");
		expect(at("A(5)")).toMatchObject({ written: "A(5)", help: "A symbol of this grammar." });
		expect(at("axiom")?.help).toContain("exactly one");
		expect(at("-->")?.help).toContain("production");
		expect(at("[ +")?.help).toContain("branch");
		expect(at("35")).toBeUndefined();
	});

	it("knows the parameters of a production within it", () => {
		expect(formalsAt(scan(TEXT), TEXT.length)).toEqual(["n"]);
		expect(formalsAt(scan(TEXT), TEXT.indexOf("axiom"))).toEqual([]);
		expect(formalsAt(scan("A(a) < B(b) > C(c) : a>1 --> F\naxiom: A"), 30)).toEqual(["a", "b", "c"]);
	});
});

describe("completion", () => {
	it("offers values in expressions, and modules in strings", () => {
		const values = offered(`${TEXT.slice(0, -4)} F(¦)`);
		expect(values).toEqual(expect.arrayContaining(["n", "angle", "clamp"]));
		expect(values).not.toContain("F");
		const modules = offered(`${TEXT} ¦`);
		expect(modules).toEqual(expect.arrayContaining(["A", "B", "F", "?E"]));
		expect(modules).not.toContain("clamp");
	});

	it("offers roles after #role, statements at the beginning of a line, and nothing in comments", () => {
		expect(offered("#role ¦ A")).toEqual(["axis", "end"]);
		expect(offered("#d¦\naxiom: A", "#d")).toContain("#define");
		expect(offered("axiom: A /* ¦ */")).toEqual([]);
	});
});
