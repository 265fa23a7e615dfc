/** A file without a specimen; the message names the file and a remedy. */
export class FileError extends Error {
	override name = "FileError";
}

/** A file that would exceed the limits of files (limits.ts); the message names a remedy. */
export class FileTooLargeError extends Error {
	override name = "FileTooLargeError";
	/**
	 * @param bytes size of the file; undefined where writing ended at the limit
	 * @param instanced whether a file in which parts share meshes is smaller
	 */
	constructor(bytes: number | undefined, most: number, instanced = false) {
		const own = bytes === undefined ? "" : `${megabytes(bytes)} MB, which is `;
		const other = instanced ? "; or choose a file whose parts share meshes (GLB, instanced)" : "";
		super(
			`The file would have ${own}more than the limit of ${megabytes(most)} MB; make the plant smaller or let it have fewer parts${other}.`,
		);
	}
}

const megabytes = (bytes: number) => Math.ceil(bytes / 1e6).toLocaleString("en");

/** A plant without any mesh, for a file that cannot be empty. */
export class EmptyPlantError extends Error {
	override name = "EmptyPlantError";
	constructor() {
		super("The plant is empty, and files for printers hold a body; change its parameters or its age until it has one.");
	}
}
