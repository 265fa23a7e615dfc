/** A file that holds no specimen; the message names the file and says what to do. */
export class FileError extends Error {
	override name = "FileError";
}
