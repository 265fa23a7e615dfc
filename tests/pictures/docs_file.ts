/** A file of the documentation as the code makes it now. */
export interface DocsFile {
	/** From the repository's root. */
	readonly path: string;
	readonly text: string;
}
