import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { mkdtemp, readdir, readFile, rm, symlink } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { nodeFiles } from "../../../web/src/cli/node_files";
import { run } from "../../../web/src/cli/run";
import { freshCore } from "../core/wasm";

let folder = "";

beforeAll(async () => {
	folder = await mkdtemp(join(tmpdir(), "panicle-files-"));
});

afterAll(() => rm(folder, { recursive: true, force: true }));

describe("files of the command", () => {
	it("are created by one of many at once, whole, and nothing else is left", async () => {
		const path = join(folder, "lock");
		const texts = Array.from({ length: 20 }, (_, k) => `${k} `.repeat(1000));
		const created = await Promise.all(texts.map((text) => nodeFiles.createFile(path, text)));
		expect(created.filter(Boolean)).toHaveLength(1);
		expect(await readFile(path, "utf8")).toBe(texts[created.indexOf(true)]);
		expect(await readdir(folder)).toEqual(["lock"]);
		await nodeFiles.removeFile(path);
		expect(await nodeFiles.createFile(path, "again")).toBe(true);
		await nodeFiles.removeFile(path);
	});

	it("tell a process that runs from one that has ended", async () => {
		const child = spawn(process.execPath, ["-e", ""]);
		await new Promise((resolve) => child.on("close", resolve));
		expect([nodeFiles.isRunning(process.pid), nodeFiles.isRunning(child.pid ?? 0)]).toEqual([true, false]);
	});

	// A device of Linux on which every write fails as on a full disk.
	it.runIf(existsSync("/dev/full"))("on a full disk end the command with 1", async () => {
		const path = join(folder, "bunch.json");
		await symlink("/dev/full", path);
		const messages: string[] = [];
		const world = {
			...nodeFiles,
			environment: {},
			loadCore: freshCore,
			print: () => {},
			printError: (line: string) => messages.push(line),
		};
		expect(await run(["redcurrant", "--set", "count=5", "--out", path], world)).toBe(1);
		expect(messages).toEqual([`grow: ${path} could not be written. The disk is full.`]);
		await rm(path);
	});
});
