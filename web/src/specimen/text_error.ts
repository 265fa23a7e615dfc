/** A mistake in a text that is read outside of the core, with its place. */
export class TextError extends Error {
	/** Both from 1. */
	constructor(
		readonly line: number,
		readonly column: number,
		message: string,
	) {
		super(`Line ${line}, column ${column}: ${message}`);
	}
}
