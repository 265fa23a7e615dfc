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
	writeFile: (path, data) => writeFile(path, data).catch((error: unknown) => withoutHalf(path, error)),
	replaceFile: async (path, data) => {
		const unfinished = `${path}.new`;
		await writeFile(unfinished, data).catch((error: unknown) => withoutHalf(unfinished, error));
		await rename(unfinished, path);
	},
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

async function createPlainly(path: string, data: string): Promise<boolean> {
	try {
		await writeFile(path, data, { flag: "wx" });
		return true;
	} catch (error) {
		if ((error as NodeJS.ErrnoException).code === "EEXIST") return false;
		throw error;
	}
}

/** Removes an incomplete file, but not a device (`/dev/full`). */
async function withoutHalf(path: string, error: unknown): Promise<never> {
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

function isRunning(id: number): boolean {
	try {
		process.kill(id, 0);
		return true;
	} catch (error) {
		// The process runs, but belongs to another user.
		return (error as NodeJS.ErrnoException).code === "EPERM";
	}
}
