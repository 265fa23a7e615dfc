/** Writes files that a call names, and distinguishes errors of the call from those of the machine. */
import { UsageError } from "./usage";

/** System codes that are errors of the call: another path can be written. */
const OF_THE_PATH: Readonly<Record<string, string>> = {
	ENOENT: "no such file or folder",
	ENOTDIR: "a part of the path is no folder",
	EISDIR: "is a folder",
	EACCES: "not allowed",
	EPERM: "not allowed",
	EROFS: "not allowed: the disk is read-only",
	ENAMETOOLONG: "the name is too long",
	EINVAL: "the name cannot be used",
};

/** System codes that are errors of the machine. */
const OF_THE_MACHINE: Readonly<Record<string, string>> = {
	ENOSPC: "the disk is full",
	EDQUOT: "the quota of the disk is used up",
	EFBIG: "the file is too large for the disk",
	EIO: "the disk fails",
	EMFILE: "too many files are open",
	ENFILE: "too many files are open",
	EPIPE: "its reader has gone",
};

/** The system's error about a file in plain words. */
export function reasonOf(error: unknown): string {
	const { code = "", message } = error as NodeJS.ErrnoException;
	return OF_THE_PATH[code] ?? OF_THE_MACHINE[code] ?? message.split("\n")[0];
}

/** A failure to write that no other call would avoid: a full disk. Ends the command with status 1. */
export class WriteError extends Error {
	override name = "WriteError";
}

/**
 * Writes, and adds the path to errors.
 * @throws UsageError where the path cannot be used, WriteError where the machine cannot write
 */
export async function writing<Result>(path: string, write: () => Promise<Result>): Promise<Result> {
	try {
		return await write();
	} catch (error) {
		const { code = "" } = error as NodeJS.ErrnoException;
		if (Object.hasOwn(OF_THE_PATH, code)) throw new UsageError(`--out ${path}: ${reasonOf(error)}`);
		throw new WriteError(`${path} cannot be written: ${reasonOf(error)}`);
	}
}
