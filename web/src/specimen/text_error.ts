/** A mistake in a text that is read outside of the core, with its position. */
export class TextError extends Error {
	/** Line and column count from 1. */
	constructor(
		readonly line: number,
		readonly column: number,
		message: string,
	) {
		super(`Line ${line}, column ${column}: ${message}`);
	}
}
