import { describe, expect, it, vi } from "vitest";
import { readArguments, rooms } from "../runner/arguments.mjs";
import { coreFolders, roomsOf } from "../runner/changed.mjs";
import { inheritedEnvironment } from "../runner/process.mjs";
import { stages } from "../runner/stages.mjs";
import { slowest, table } from "../runner/times.mjs";

const STAGES = ["set-up", "docs", "lint", "types", "native", "wasm", "web", "app", "e2e", "sizes", "browsers"];
const all = [...STAGES.map((name) => ({ name })), { name: "soak", isLong: true }];
const read = (...words: string[]) => readArguments(words, all);
const changes =
	(...files: string[]) =>
	() =>
		files;

describe("the arguments of a test run", () => {
	it("choose the gate when there are none, and everything with --long", () => {
		expect(read()).toEqual({ isLong: false, stages: STAGES, native: ["core_tests"], web: [], endToEnd: [] });
		expect(read("--long")).toMatchObject({ isLong: true, stages: [...STAGES, "soak"] });
		expect(read("soak")).toMatchObject({ stages: ["set-up", "wasm", "app", "soak"] });
	});

	it("choose one model's tests: in the core, in the page, and those of all models", () => {
		expect(read("bunch")).toMatchObject({
			stages: ["set-up", "native", "wasm", "web"],
			native: ["bunch_tests"],
			web: ["tests/web/models/bunch/", "tests/golden/native_wasm.test.ts"],
		});
	});

	it("choose a room's native or web tests", () => {
		expect(read("lsystem")).toMatchObject({ stages: ["set-up", "native"], native: ["lsystem_tests"], web: [] });
		expect(read("ui")).toMatchObject({ stages: ["set-up", "wasm", "web"], web: ["tests/web/ui/"] });
		expect(read("core")).toMatchObject({
			stages: ["set-up", "native", "wasm", "web"],
			native: ["core_tests"],
			web: ["tests/web/core/"],
		});
	});

	it("choose both the stage and the room where a word names both", () => {
		expect(read("app")).toMatchObject({ stages: ["set-up", "wasm", "web", "app"], web: ["tests/web/app/"] });
	});

	it("choose all models' tests, or those of a folder beside the rooms", () => {
		expect(read("models")).toMatchObject({
			native: ["bunch", "flower", "grammar", "growth", "leaf", "particles", "root", "stand", "tree"].map(
				(each) => `${each}_tests`,
			),
			web: ["tests/web/models/", "tests/golden/"],
		});
		for (const folder of ["fuzz", "golden", "tools", "toy"]) {
			expect(read(folder)).toMatchObject({ stages: ["set-up", "wasm", "web"], web: [`tests/${folder}/`] });
		}
	});

	it("choose a stage whole where it is named beside a room", () => {
		expect(read("types", "web", "ui", "lsystem")).toMatchObject({
			stages: ["set-up", "types", "native", "wasm", "web"],
			native: ["lsystem_tests"],
			web: [],
		});
		expect(read("unit")).toMatchObject({
			stages: ["set-up", "native", "wasm", "web"],
			native: ["core_tests"],
			web: [],
		});
	});

	it("add the stages that build the app where a stage looks at it", () => {
		for (const stage of ["e2e", "browsers"])
			expect(read(stage)).toMatchObject({ stages: ["set-up", "wasm", "app", stage] });
	});

	it("name only stages that exist", () => {
		const names = stages.map(({ name }) => name);
		const { stages: chosen } = readArguments(["e2e", "sizes", "browsers", "unit"], stages) as { stages: string[] };
		expect(chosen).toEqual(names.filter((name) => chosen.includes(name)));
		expect(chosen).toEqual(["set-up", "native", "wasm", "web", "app", "e2e", "sizes", "browsers"]);
	});

	it("return a problem for unknown words and options", () => {
		expect(read("bunch", "grapes")).toEqual({ problem: expect.stringMatching(/^No stage, room or model “grapes”; /) });
		expect(read("--slow")).toEqual({ problem: expect.stringMatching(/^Unknown option --slow/) });
		expect(read("--changed", "bunch")).toHaveProperty("problem");
		expect(rooms()).toEqual(expect.arrayContaining(["bunch", "core", "lsystem", "render", "specimen"]));
	});
});

describe("the tests of what changed", () => {
	it.each([
		"wasm-core/src/expression/code.cpp",
		"wasm-core/parameters/bunch.json",
		"wasm-core/grammars/flower/tulip.gl3",
		"tests/core/fuzz_dice.hpp",
	])("are all native and web tests where %s changed, for every model grows by the core", (file) => {
		const changed = changes(file, "tests/e2e/link.spec.ts", "tests/e2e/gone.spec.ts");
		expect(readArguments(["--changed"], all, changed)).toEqual({
			isLong: false,
			stages: ["set-up", "docs", "lint", "types", "native", "wasm", "web", "app", "e2e"],
			native: ["core_tests"],
			web: [],
			endToEnd: ["tests/e2e/link.spec.ts"],
		});
	});

	it("are none where nothing changed, and the run says so", () => {
		expect(readArguments(["--changed"], all, changes())).toEqual({
			nothing: expect.stringMatching(/^Nothing has changed/),
		});
	});

	it("are the web tests that import a changed file where the core did not change", () => {
		expect(readArguments(["--changed"], all, changes("README.md"))).toEqual({
			isLong: false,
			stages: ["set-up", "docs", "lint", "types", "wasm", "web"],
			native: [],
			web: [expect.stringMatching(/^--changed=[0-9a-f]{40}$/)],
			endToEnd: [],
		});
	});
});

describe("the rooms to sanitize", () => {
	it("are those whose sources, tests, grammars or tables changed, models by their names", () => {
		const files = ["wasm-core/src/plant/plant.cpp", "tests/core/models/bunch/bunch_test.cpp", "web/src/core/core.ts"];
		expect(roomsOf(files)).toEqual(["bunch", "plant"]);
		expect(roomsOf(["wasm-core/grammars/flower/tulip.gl3", "wasm-core/parameters/growth.measures.json"])).toEqual([
			"flower",
			"growth",
		]);
	});

	it("are all where changes are unknown or concern every room", () => {
		expect(roomsOf(undefined)).toEqual(coreFolders());
		for (const file of ["wasm-core/CMakeLists.txt", "tests/core/main.cpp"])
			expect(roomsOf([file])).toEqual(coreFolders());
		expect(coreFolders()).toEqual(expect.arrayContaining(["exports", "foundation", "flower"]));
		expect(coreFolders()).not.toContain("models");
	});
});

describe("the times at the end of a run", () => {
	const results = [
		{
			name: "native",
			seconds: 20,
			passed: 2,
			failed: 0,
			tests: [
				{ name: "a", seconds: 1 },
				{ name: "b", seconds: 3 },
			],
		},
		{ name: "web", seconds: 30, passed: 1, failed: 1, tests: [{ name: "c", seconds: 2 }] },
	];

	it("name the slowest tests of all stages, slowest first", () => {
		expect(slowest(results, 2)).toEqual([
			{ stage: "native", name: "b", seconds: 3 },
			{ stage: "web", name: "c", seconds: 2 },
		]);
	});

	it("have a row for each stage, those that did not run too, and the total", () => {
		const text = table([{ name: "native" }, { name: "web" }, { name: "e2e" }], results, slowest(results, 1));
		expect(text.split("\n").map((line) => line.trim().replace(/ +/g, " "))).toEqual([
			"native 20.0 s 2 passed, 0 failed",
			"web 30.0 s 1 passed, 1 failed",
			"e2e not run",
			"total 50.0 s",
			"",
			"Slowest tests:",
			"3.0 s native: b",
		]);
	});
});

describe("the programs of a stage", () => {
	it("inherit the environment without NODE_ENV, or Vite would build the app for development", () => {
		vi.stubEnv("NODE_ENV", "development");
		vi.stubEnv("PANICLE_LONG", "1");
		const environment = inheritedEnvironment();
		vi.unstubAllEnvs();
		expect(environment).not.toHaveProperty("NODE_ENV");
		expect(environment).toMatchObject({ PANICLE_LONG: "1" });
	});
});
