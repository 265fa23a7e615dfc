/** A file that holds no specimen; the message names the file and says what to do. */
export class FileError extends Error {
	override name = "FileError";
}

/** A plant without any mesh, for a file that cannot be empty. */
export class EmptyPlantError extends Error {
	override name = "EmptyPlantError";
	constructor() {
		super("The plant is empty, and files for printers hold a body; change its parameters or its age until it has one.");
	}
}
