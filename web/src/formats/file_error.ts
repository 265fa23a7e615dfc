import { MessageError } from "../locale/message_error";
import { text } from "./messages.generated";

/** A file without a specimen; the message names the file and a remedy. */
export class FileError extends MessageError {
	override name = "FileError";
}

/** A file that would exceed the limits of files (limits.ts); the message names a remedy. */
export class FileTooLargeError extends MessageError {
	override name = "FileTooLargeError";
	/**
	 * @param bytes size of the file; undefined where writing ended at the limit
	 * @param instanced whether a file in which parts share meshes is smaller
	 */
	constructor(bytes: number | undefined, most: number, instanced = false) {
		const limit = megabytes(most);
		if (bytes === undefined) super(text.message("export_too_large", { max: limit }));
		else {
			const key = instanced ? "export_too_large_instanced" : "export_too_large_size";
			super(text.message(key, { size: megabytes(bytes), max: limit }));
		}
	}
}

/** Returns bytes as whole megabytes, rounded up. */
const megabytes = (bytes: number) => Math.ceil(bytes / 1e6);

/** A plant without any mesh, for a file that cannot be empty. */
export class EmptyPlantError extends MessageError {
	override name = "EmptyPlantError";
	constructor() {
		super(text.message("export_empty"));
	}
}
