/** Locks a build folder, so that only one process at a time builds in it. */
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

function isAlive(id) {
	try {
		process.kill(id, 0);
		return true;
	} catch (error) {
		return error.code === "EPERM";
	}
}

/** Takes the lock file `path` for this process, or removes one whose process has ended. */
function take(path) {
	try {
		writeFileSync(path, String(process.pid), { flag: "wx" });
		return true;
	} catch (error) {
		if (error.code !== "EEXIST") throw error;
	}
	try {
		const owner = Number(readFileSync(path, "utf8"));
		if (owner > 0 && !isAlive(owner)) rmSync(path, { force: true });
	} catch {
		// Released in the meantime: the next try gets it.
	}
	return false;
}

/**
 * Runs `work` while no other process holds the lock file `path`.
 *
 * @template T
 * @param {string} path
 * @param {() => Promise<T>} work
 * @returns {Promise<T>}
 */
export async function withLock(path, work) {
	mkdirSync(dirname(path), { recursive: true });
	while (!take(path)) await sleep(50);
	try {
		return await work();
	} finally {
		rmSync(path, { force: true });
	}
}
