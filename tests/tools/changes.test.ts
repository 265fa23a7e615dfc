import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { changeBase, changedFiles, gateBase } from "../../wasm-core/tools/changes.mjs";

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

	it("are the uncommitted ones on main, and those since a named commit", () => {
		const first = commit("a");
		const second = commit("b");
		expect(changeBase({ folder, env: {} })).toBe(second);
		expect(changedFiles({ folder, env: {} })).toEqual([]);
		writeFileSync(join(folder, "a"), "changed");
		expect(changedFiles({ folder, env: {} })).toEqual(["a"]);
		expect(changedFiles({ folder, env: { PANICLE_BASE: first } })).toEqual(["a", "b"]);
	});

	it("are counted by the gate since the last release on main, and else since the branch left it", () => {
		commit("a");
		expect(gateBase({ folder, env: {} })).toBeUndefined();
		mkdirSync(join(folder, "tests/sizes"), { recursive: true });
		const release = commit("tests/sizes/last_release.json");
		const last = commit("b");
		expect(gateBase({ folder, env: {} })).toBe(release);
		git("checkout", "-q", "-b", "topic");
		commit("c");
		expect(gateBase({ folder, env: {} })).toBe(last);
	});

	it("are unknown without git", () => {
		rmSync(join(folder, ".git"), { recursive: true });
		expect(changedFiles({ folder, env: {} })).toBeUndefined();
		expect(gateBase({ folder, env: {} })).toBeUndefined();
	});
});
