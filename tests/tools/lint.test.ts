import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { changeBase, changedFiles } from "../../wasm-core/tools/changes.mjs";
import { unitsOf } from "../../wasm-core/tools/lint.mjs";
import { listOfTasks, runTask } from "../../wasm-core/tools/tasks.mjs";

describe("the files that clang-tidy checks for a change", () => {
	const units = ["wasm-core/src/mesh/tube.cpp", "wasm-core/src/plant/grow.cpp"];
	const texts: Record<string, string> = {
		"wasm-core/src/mesh/tube.cpp": '#include "mesh/tube.hpp"\n',
		"wasm-core/src/plant/grow.cpp": '#include "mesh/tube.hpp"\n#include "plant/request.hpp"\n',
	};
	const of = (...changed: string[]) => unitsOf(changed, units, (path: string) => texts[path]);

	it("are changed sources themselves, and the source of the same name or one that includes it for a header", () => {
		expect(of("wasm-core/src/plant/grow.cpp")).toEqual(["wasm-core/src/plant/grow.cpp"]);
		expect(of("wasm-core/src/mesh/tube.hpp")).toEqual(["wasm-core/src/mesh/tube.cpp"]);
		expect(of("wasm-core/src/plant/request.hpp")).toEqual(["wasm-core/src/plant/grow.cpp"]);
	});

	it("are listed once, and leave out what is not of the core or not compiled", () => {
		expect(of("wasm-core/src/mesh/tube.hpp", "wasm-core/src/mesh/tube.cpp")).toEqual(["wasm-core/src/mesh/tube.cpp"]);
		expect(
			of("web/src/app.ts", "tests/core/mesh_test.cpp", "wasm-core/src/new.cpp", "wasm-core/src/unused.hpp"),
		).toEqual([]);
	});
});

describe("changed files", () => {
	let folder: string;
	const git = (...words: string[]) =>
		execFileSync("git", ["-C", folder, "-c", "user.name=t", "-c", "user.email=t@t.example", ...words], {
			encoding: "utf8",
			stdio: "pipe",
		}).trim();
	const commit = (file: string) => {
		writeFileSync(join(folder, file), file);
		git("add", file);
		git("commit", "-q", "-m", file);
		return git("rev-parse", "HEAD");
	};

	beforeEach(() => {
		folder = mkdtempSync(join(tmpdir(), "panicle-changes-"));
		git("init", "-q", "-b", "main");
	});
	afterEach(() => rmSync(folder, { recursive: true }));

	it("are those of a branch since it left main, with new and uncommitted ones", () => {
		const left = commit("a");
		git("checkout", "-q", "-b", "topic");
		commit("b");
		commit("c");
		git("rm", "-q", "b");
		writeFileSync(join(folder, "a"), "changed");
		writeFileSync(join(folder, "new"), "");
		expect(changeBase({ folder, env: {} })).toBe(left);
		expect(changedFiles({ folder, env: {} })).toEqual(["a", "c", "new"]);
	});

	it("are those of the last commit on main, and those since a named commit", () => {
		const first = commit("a");
		const second = commit("b");
		commit("c");
		expect(changeBase({ folder, env: {} })).toBe(second);
		expect(changedFiles({ folder, env: { PANICLE_BASE: first } })).toEqual(["b", "c"]);
	});

	it("are unknown without a history", () => {
		commit("a");
		expect(changedFiles({ folder, env: {} })).toBeUndefined();
	});
});

describe("scripts with named tasks", () => {
	const tasks = (run: (words: string[]) => void) => ({
		small: { about: "a small task", run },
		large: { about: "a large task", words: "[WORD]", run },
	});

	afterEach(() => {
		process.exitCode = undefined;
		vi.restoreAllMocks();
	});

	it("pass the words after the name to the task", async () => {
		const run = vi.fn();
		await runTask("bench", tasks(run), ["large", "a", "--b"]);
		expect(run).toHaveBeenCalledExactlyOnceWith(["a", "--b"]);
	});

	it("run the standard task without a name, or list the tasks", async () => {
		const [run, standard] = [vi.fn(), vi.fn()];
		const log = vi.spyOn(console, "log").mockImplementation(() => {});
		await runTask("bench", tasks(run), ["--check"], { standard });
		expect(standard).toHaveBeenCalledTimes(1);
		await runTask("bench", tasks(run), []);
		await runTask("bench", tasks(run), ["--help"], { standard });
		const list = "npm run bench -- NAME\n  small         a small task\n  large [WORD]  a large task";
		expect(listOfTasks("bench", tasks(run))).toBe(list);
		expect(log.mock.calls).toEqual([[list], [list]]);
		expect([run.mock.calls.length, standard.mock.calls.length]).toEqual([0, 1]);
	});

	it("end with status 2 and the list where the name is unknown", async () => {
		const [run, error] = [vi.fn(), vi.spyOn(console, "error").mockImplementation(() => {})];
		await runTask("bench", tasks(run), ["toString"]);
		expect(process.exitCode).toBe(2);
		expect(error.mock.calls[0][0]).toContain("No task “toString”.\nnpm run bench -- NAME");
		expect(run).not.toHaveBeenCalled();
	});
});
