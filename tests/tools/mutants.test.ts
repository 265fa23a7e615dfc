import { readdirSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { readCheckout } from "../mutants/copy.mjs";
import { groups } from "../mutants/list/index.mjs";
import {
	applied,
	keyOf,
	mutantsOf,
	parseArguments,
	problemsOf,
	programOf,
	repeatedIds,
	selected,
	sharded,
	suiteOf,
} from "../mutants/mutants.mjs";
import { complaints, report, shareCaught } from "../mutants/report.mjs";
import { syntaxError } from "../mutants/suites.mjs";

const fault = { id: "sum-is-difference", find: "a + b", replace: "a - b", breaks: "sums are wrong" };
const files: Record<string, string> = {
	"web/sum.ts": "export const sum = (a, b) => a + b;",
	"tests/web/sum.test.ts": "it('adds')",
	"tests/e2e/sum.spec.ts": 'test("shows the sum")',
	"tests/core/models/bunch/sum_test.cpp": "TEST_CASE",
};
const read = (path: string) => files[path];
const one = (more: object = {}, suites = ["tests/web/sum.test.ts"]) =>
	mutantsOf([{ file: "web/sum.ts", suites, faults: [{ ...fault, ...more }] }])[0];

describe("the list of mutants", () => {
	const all = mutantsOf(groups);

	it("is not stale: what is to be found stands there once, and so do the suites", () => {
		expect(all.flatMap((mutant) => problemsOf(mutant, readCheckout))).toEqual([]);
	});

	it("has a unique id and describes its visible effect", () => {
		expect(repeatedIds(all)).toEqual([]);
		expect(all.filter(({ id }) => !/^[a-z0-9-]+$/.test(id))).toEqual([]);
		expect(all.filter(({ breaks }) => breaks.length < 10)).toEqual([]);
	});

	it("names suites that a runner runs: files of doctest, vitest or Playwright, or folders with files of vitest", () => {
		const runs = (suite: string) => {
			const { kind, path } = suiteOf(suite);
			if (kind === "core") return /^tests\/core\/.*_test\.cpp$/.test(path);
			if (kind === "e2e") return /^tests\/e2e\/.*\.spec\.ts$/.test(path);
			if (path.endsWith("/"))
				return readdirSync(join(repository, path), { recursive: true, encoding: "utf8" }).some((file) =>
					file.endsWith(".test.ts"),
				);
			return /^tests\/(?:(?:web|golden|fuzz|tools|toy|package|docs|browsers)\/.*|[^/]*)\.test\.ts$/.test(path);
		};
		const suites = new Set(all.flatMap((mutant) => mutant.suites));
		expect([...suites].filter((suite) => !runs(suite))).toEqual([]);
	});

	it("names the reason of every survivor, and these are few", () => {
		const surviving = all.filter(({ survives }) => survives !== undefined);
		expect(surviving.filter(({ survives }) => (survives ?? "").length < 20)).toEqual([]);
		expect(surviving.length).toBeLessThanOrEqual(0.05 * all.length);
	});
});

describe("a mutant", () => {
	it("is applied where its place is the only one", () => {
		expect(applied("a + b", fault)).toBe("a - b");
		expect(applied("a + b; a + b", fault)).toBeUndefined();
		expect(applied("a * b", fault)).toBeUndefined();
		expect(applied("x", { ...fault, find: "x", replace: "$&$1" })).toBe("$&$1");
	});

	it("is stale where its place, its suites or their tests are gone", () => {
		expect(problemsOf(one(), read)).toEqual([]);
		expect(problemsOf(one({ find: "a * b" }), read)).toEqual([expect.stringContaining("0 times")]);
		expect(problemsOf(one({ replace: "a + b" }), read)).toEqual([expect.stringContaining("changes nothing")]);
		expect(problemsOf(one({}, ["tests/web/gone.test.ts"]), read)).toEqual([expect.stringContaining("not there")]);
		expect(problemsOf(one({}, ["tests/e2e/sum.spec.ts: shows the sum"]), read)).toEqual([]);
		expect(problemsOf(one({}, ["tests/e2e/sum.spec.ts: hides it"]), read)).toEqual([
			expect.stringContaining("hides it"),
		]);
		const generated = { ...one(), file: "web/sum.generated.ts" };
		expect(problemsOf(generated, () => "a + b")).toEqual([expect.stringContaining("mutate the table")]);
	});

	it("is run again where its file, its tests or itself are others, and not else", () => {
		const key = keyOf(one(), read);
		expect(keyOf(one({ breaks: "other words" }), read)).toBe(key);
		expect(keyOf(one({ replace: "a * b" }), read)).not.toBe(key);
		for (const file of ["web/sum.ts", "tests/web/sum.test.ts"])
			expect(keyOf(one(), (path: string) => read(path) + (path === file ? " " : ""))).not.toBe(key);
		expect(keyOf(one(), (path: string) => (path === "tests/e2e/sum.spec.ts" ? "" : read(path)))).toBe(key);
	});

	it("knows by its suite what kind it is", () => {
		expect(suiteOf("tests/e2e/sum.spec.ts: GLB: valid")).toEqual({
			kind: "e2e",
			path: "tests/e2e/sum.spec.ts",
			title: "GLB: valid",
		});
		expect(suiteOf("tests/web/formats/").kind).toBe("web");
		expect(one({ suites: ["tests/core/models/bunch/sum_test.cpp"] }).kind).toBe("core");
		expect(programOf("tests/core/models/bunch/sum_test.cpp")).toBe("bunch_tests");
		expect(programOf("tests/core/lsystem/sum_test.cpp")).toBe("lsystem_tests");
	});

	it("that does not parse is told from one that breaks something", async () => {
		expect(await syntaxError("web/sum.ts", "export const a = (;")).toBeDefined();
		expect(await syntaxError("web/sum.ts", "export const a: number = 1;")).toBeUndefined();
	});
});

describe("a run", () => {
	const several = mutantsOf([
		{
			file: "web/sum.ts",
			suites: ["tests/web/sum.test.ts"],
			faults: ["a", "b", "c", "d", "e"].map((id) => ({ ...fault, id })),
		},
		{ file: "core/sum.cpp", suites: ["tests/core/models/bunch/sum_test.cpp"], faults: [{ ...fault, id: "f" }] },
	]);
	const ids = (some: typeof several) => some.map(({ id }) => id);

	it("takes the kinds in turn, quickest first", () => {
		expect(ids(several)).toEqual(["f", "a", "b", "c", "d", "e"]);
	});

	it("is of what the words name", () => {
		expect(ids(selected(several, ["core"]))).toEqual(["f"]);
		expect(ids(selected(several, ["web/sum"]))).toEqual(["a", "b", "c", "d", "e"]);
		expect(selected(several, [])).toEqual(several);
	});

	it("is shared out among several, each mutant once", () => {
		const parts = [1, 2, 3].map((part) => ids(sharded(several, part, 3)));
		expect(parts.flat().sort()).toEqual(["a", "b", "c", "d", "e", "f"]);
		expect(Math.max(...parts.map(({ length }) => length))).toBeLessThanOrEqual(3);
	});

	it("understands its call", () => {
		expect(parseArguments(["specimen", "--shard", "2/4", "--again"])).toEqual({
			words: ["specimen"],
			part: 2,
			parts: 4,
			again: true,
			report: false,
		});
		expect(parseArguments(["--shard", "5/4"])).toHaveProperty("wrong");
		expect(parseArguments(["--all"])).toHaveProperty("wrong");
	});

	it("complains of survivors, of reasons that hold no more, and of what does not compile", () => {
		const [f, a, b, c] = several;
		const list = [f, a, { ...b, survives: "no test can see it" }, { ...c, survives: "no test can see it" }];
		const results = new Map([
			["f", { key: "", outcome: "invalid" as const, why: "no such name", seconds: 1 }],
			["a", { key: "", outcome: "survived" as const, seconds: 1 }],
			["b", { key: "", outcome: "survived" as const, seconds: 1 }],
			["c", { key: "", outcome: "caught" as const, by: "tests/web/sum.test.ts", seconds: 2 }],
		]);
		expect(complaints(list, results)).toEqual([
			expect.stringContaining("f does not compile"),
			expect.stringContaining("a survives"),
			expect.stringContaining("c is caught by now"),
		]);
		expect(shareCaught(list, results)).toBeCloseTo(1 / 3);
		const text = report(list, results);
		expect(text).toMatch(/all +4 +1 +2 +1 +0 +0 +5 s/);
		expect(text).toContain("b survives, as is known: no test can see it");
	});
});
