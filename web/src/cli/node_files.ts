/** Files and processes of Node for the command (surroundings.ts). */
import { randomUUID } from "node:crypto";
import { appendFile, link, lstat, mkdir, readdir, readFile, rename, rm, writeFile } from "node:fs/promises";
import { hostname } from "node:os";
import type { CommandEnvironment } from "./surroundings";

type Files = Pick<
	CommandEnvironment,
	| "readFile"
	| "writeFile"
	| "replaceFile"
	| "createFile"
	| "appendFile"
	| "removeFile"
	| "makeFolder"
	| "listFolder"
	| "host"
	| "process"
	| "isRunning"
	| "now"
	| "elapsed"
	| "whenTerminated"
>;

/** Exit status of a process that SIGTERM has ended, as shells report it. */
const TERMINATED = 143;

export const nodeFiles: Files = {
	readFile,
	writeFile: (path, data) => writeFile(path, data).catch((error: unknown) => removeIncomplete(path, error)),
	replaceFile: async (path, data) => {
		const unfinished = `${path}.new`;
		await writeFile(unfinished, data).catch((error: unknown) => removeIncomplete(unfinished, error));
		await rename(unfinished, path);
	},
	/**
	 * Creates a file with its whole content at once, unless it exists: the content is written under another name first,
	 * and then linked. Returns whether the file was created.
	 */
	createFile: async (path, data) => {
		const unfinished = `${path}.${randomUUID()}.new`;
		try {
			await writeFile(unfinished, data);
			await link(unfinished, path);
			return true;
		} catch (error) {
			const { code = "" } = error as NodeJS.ErrnoException;
			if (code === "EEXIST") return false;
			if (WITHOUT_LINKS.includes(code)) return createPlainly(path, data);
			throw error;
		} finally {
			await rm(unfinished, { force: true });
		}
	},
	appendFile,
	removeFile: (path) => rm(path, { force: true }),
	makeFolder: async (path) => void (await mkdir(path, { recursive: true })),
	listFolder: (path) => readdir(path),
	host: hostname(),
	process: process.pid,
	isRunning,
	now: Date.now,
	elapsed: () => performance.now(),
	whenTerminated: (work) => {
		const listener = () => void work().finally(() => process.exit(TERMINATED));
		process.once("SIGTERM", listener);
		return () => process.off("SIGTERM", listener);
	},
};

/** Error codes of file systems without hard links. */
const WITHOUT_LINKS = ["EPERM", "ENOTSUP", "EOPNOTSUPP", "ENOSYS"];

/** Creates a file without a hard link, so that a crash may leave part of it. Returns whether it was created. */
async function createPlainly(path: string, data: string): Promise<boolean> {
	try {
		await writeFile(path, data, { flag: "wx" });
		return true;
	} catch (error) {
		if ((error as NodeJS.ErrnoException).code === "EEXIST") return false;
		throw error;
	}
}

/** Removes the incomplete file of a failed write, but not a device (`/dev/full`), and throws the error again. */
async function removeIncomplete(path: string, error: unknown): Promise<never> {
	const isFile = await lstat(path).then(
		(found) => found.isFile(),
		() => false,
	);
	const { code = "" } = error as NodeJS.ErrnoException;
	if (isFile && FULL.includes(code)) await rm(path, { force: true });
	throw error;
}

/** Error codes in the middle of writing. */
const FULL = ["ENOSPC", "EDQUOT", "EFBIG", "EIO"];

/** Returns whether a process of this machine runs; signal 0 only checks that. */
function isRunning(id: number): boolean {
	try {
		process.kill(id, 0);
		return true;
	} catch (error) {
		// The process runs, but belongs to another user.
		return (error as NodeJS.ErrnoException).code === "EPERM";
	}
}
