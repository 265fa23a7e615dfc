import { execFileSync } from "node:child_process";
import {
	cpSync,
	existsSync,
	mkdirSync,
	mkdtempSync,
	readdirSync,
	readFileSync,
	rmSync,
	statSync,
	utimesSync,
	writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { checkTable } from "../../wasm-core/tools/generate/check_table.mjs";
import { generate, generatedFiles } from "../../wasm-core/tools/generate/files.mjs";
import { checkMeasures } from "../../wasm-core/tools/generate/measures.mjs";
import { coreCatalogues, pageCatalogues, translations } from "../../wasm-core/tools/generate/messages.mjs";
import { coreFolder, repository } from "../../wasm-core/tools/repository.mjs";

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

describe("generate", () => {
	let root: string;
	beforeEach(() => {
		root = mkdtempSync(join(tmpdir(), "panicle-generate-"));
	});
	afterEach(() => rmSync(root, { recursive: true }));

	const files = generatedFiles();
	const paths = files.map(({ path }) => path);
	const put = (path: string, text = "") => {
		mkdirSync(dirname(join(root, path)), { recursive: true });
		writeFileSync(join(root, path), text);
	};
	/** Paths below the root, folders left out. */
	const found = () =>
		readdirSync(root, { recursive: true, encoding: "utf8" }).filter((path) => statSync(join(root, path)).isFile());

	it("writes every file into an empty folder", () => {
		expect(generate({ root })).toEqual(paths);
		expect(found().sort()).toEqual([...paths].sort());
		for (const { path, text } of files) expect(readFileSync(join(root, path), "utf8")).toBe(text);
		expect(paths).toContain("wasm-core/src/models/leaf/parameters.generated.hpp");
		expect(paths).toContain("web/src/models/bunch/grammars.generated.ts");
		expect(paths).toContain("docs/language.md");
	});

	it("writes only code, or only pages of documentation, where that is requested", () => {
		const code = paths.filter((path) => !path.startsWith("docs/"));
		expect(generate({ root, only: "code" })).toEqual(code);
		expect(found().sort()).toEqual([...code].sort());
		expect(generate({ root, only: "pages" })).toEqual(paths.filter((path) => path.startsWith("docs/")));
	});

	it("rewrites only the files whose text differs", () => {
		generate({ root });
		for (const path of paths) utimesSync(join(root, path), 1e9, 1e9);
		const [changed, ...same] = paths;
		writeFileSync(join(root, changed), "another text");
		expect(generate({ root })).toEqual([changed]);
		for (const path of same) expect(statSync(join(root, path)).mtimeMs, path).toBe(1e12);
		expect(statSync(join(root, changed)).mtimeMs).toBeGreaterThan(1e12);
		expect(generate({ root })).toEqual([]);
	});

	it("removes code that no table makes, with the folders that are empty then", () => {
		const orphans = [
			"wasm-core/src/models/gone/measures/measures.generated.hpp",
			"web/src/models/gone/parameters.generated.ts",
			"web/src/models/grammar/gone.generated.ts",
		];
		const own = ["web/src/models/gone/index.ts", "web/src/models/gone.ts", "docs/gone.generated.md"];
		generate({ root });
		for (const path of [...orphans, ...own]) put(path);
		expect(generate({ root, only: "code" }).sort()).toEqual(orphans);
		expect(found().sort()).toEqual([...paths, ...own].sort());
		expect(existsSync(join(root, "wasm-core/src/models/gone"))).toBe(false);
	});

	it("writes and removes nothing when it only checks", () => {
		const orphan = "web/src/models/gone/parameters.generated.ts";
		put(orphan);
		expect(generate({ write: false, root })).toEqual([...paths, orphan]);
		expect(found()).toEqual([orphan]);
	});

	it("runs where no package is installed", () => {
		for (const folder of ["tools", "parameters", "grammars"])
			cpSync(join(coreFolder, folder), join(root, "wasm-core", folder), { recursive: true });
		for (const folder of readdirSync(join(coreFolder, "src/models")))
			mkdirSync(join(root, "wasm-core/src/models", folder), { recursive: true });
		const catalogues = [...pageCatalogues(), ...coreCatalogues()].map(({ source }) => source);
		for (const source of [...catalogues, ...translations().map((name) => `web/src/locale/${name}`)])
			cpSync(join(repository, source), join(root, source), { recursive: true });
		execFileSync(process.execPath, ["wasm-core/tools/generate.mjs"], { cwd: root, stdio: "pipe" });
		const code = files.filter(({ path }) => !path.startsWith("docs/"));
		for (const { path, text } of code) expect(readFileSync(join(root, path), "utf8"), path).toBe(text);
	});
});

it("finds every page of documentation up to date", () => expect(generate({ write: false })).toEqual([]));
