/** What a build consists of, as web/offline_app.mjs writes it into its service worker. */
export interface Built {
	/** The app's version: files of the same plant may differ from one to the next. */
	readonly release: string;
	/** Tells this build from every other. */
	readonly id: string;
	/** Its files by their paths in the app's folder, the page itself as "": what they must be, as `integrity` has it. */
	readonly files: Readonly<Record<string, string>>;
	/** Paths of the cores by what models call them: `tree.wasm`. */
	readonly cores: Readonly<Record<string, string>>;
	/** The path of the script that answers for specimens. */
	readonly specimens: string;
}

/** Files whose names tell what is in them: what has the same path is the same. */
export const isNamedByContent = (path: string): boolean => path.startsWith("assets/");
