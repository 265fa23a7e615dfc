/** The description of a build, which web/offline_app.mjs writes into its service worker. */
export interface Built {
	/** The app's version: files of the same plant may differ between versions. */
	readonly release: string;
	/** A unique id of this build. */
	readonly id: string;
	/** Integrity values of its files by their paths in the app's folder; the path of the page itself is "". */
	readonly files: Readonly<Record<string, string>>;
	/** Paths of the cores by file name: `tree.wasm`. */
	readonly cores: Readonly<Record<string, string>>;
	/** The path of the script that serves specimens. */
	readonly specimens: string;
}

/** Returns whether a file's name depends on its content: equal paths mean equal files. */
export const isNamedByContent = (path: string): boolean => path.startsWith("assets/");
