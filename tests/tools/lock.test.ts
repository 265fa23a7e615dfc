import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { afterEach, beforeEach, expect, it } from "vitest";
import { withLock } from "../../wasm-core/tools/lock.mjs";

let folder: string;
let lock: string;

beforeEach(() => {
	folder = mkdtempSync(join(tmpdir(), "lock-"));
	lock = join(folder, "build.lock");
});
afterEach(() => rmSync(folder, { recursive: true }));

it("lets one at a time in, and gives back what each made", async () => {
	let inside = 0;
	let most = 0;
	const work = async (value: number) => {
		inside++;
		most = Math.max(most, inside);
		await sleep(20);
		inside--;
		return value;
	};
	expect(await Promise.all([1, 2, 3].map((value) => withLock(lock, () => work(value))))).toEqual([1, 2, 3]);
	expect(most).toBe(1);
});

it("is given back when the work fails", async () => {
	await expect(withLock(lock, () => Promise.reject(new Error("no")))).rejects.toThrow("no");
	expect(existsSync(lock)).toBe(false);
});

it("is taken from a process that is gone", async () => {
	writeFileSync(lock, "4194305"); // above the greatest id that Linux gives
	expect(await withLock(lock, async () => "mine")).toBe("mine");
});
