/** Writes files that a call names, and distinguishes errors of the call from those of the machine. */

import { MessageError } from "../locale/message_error";
import type { Message } from "../locale/texts";
import { text } from "./messages.generated";
import { optionError } from "./usage";

/** System codes that are errors of the call: another path can be written. */
const OF_THE_PATH = {
	ENOENT: "file_missing",
	ENOTDIR: "file_part_no_folder",
	EISDIR: "file_is_folder",
	EACCES: "file_not_allowed",
	EPERM: "file_not_allowed",
	EROFS: "file_read_only",
	ENAMETOOLONG: "file_name_too_long",
	EINVAL: "file_name_invalid",
} as const;

/** System codes that are errors of the machine. */
const OF_THE_MACHINE = {
	ENOSPC: "disk_full",
	EDQUOT: "disk_quota",
	EFBIG: "disk_too_small",
	EIO: "disk_broken",
	EMFILE: "too_many_open_files",
	ENFILE: "too_many_open_files",
	EPIPE: "reader_gone",
} as const;

const REASONS = { ...OF_THE_PATH, ...OF_THE_MACHINE };

/** Returns the system's error about a file as a sentence. */
export function reasonOf(error: unknown): Message {
	const { code = "", message } = error as NodeJS.ErrnoException;
	if (Object.hasOwn(REASONS, code)) return text.message(REASONS[code as keyof typeof REASONS]);
	return { code: "", args: {}, text: message.split("\n")[0] };
}

/** A failure to write that no other call would avoid: a full disk. Ends the command with status 1. */
export class WriteError extends MessageError {
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
		if (Object.hasOwn(OF_THE_PATH, code)) throw optionError(`--out ${path}`, reasonOf(error));
		throw new WriteError(text.message("not_written", { file: path, reason: reasonOf(error).text }));
	}
}
