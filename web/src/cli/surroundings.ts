import type { Core } from "../core/core";

/** What the command needs of the world outside; tests give it another. */
export interface Surroundings {
	readFile(path: string): Promise<Uint8Array>;
	writeFile(path: string, data: string | Uint8Array): Promise<void>;
	/** Writes a file that is whole or not there under its name, whatever happens meanwhile. */
	replaceFile(path: string, data: string | Uint8Array): Promise<void>;
	appendFile(path: string, text: string): Promise<void>;
	/** One that is not there is no error. */
	removeFile(path: string): Promise<void>;
	/** With those above it; one that is there is no error. */
	makeFolder(path: string): Promise<void>;
	/** Variables by name. */
	readonly environment: Readonly<Record<string, string | undefined>>;
	/** @param wasm the file of a model's core: `bunch.wasm` */
	loadCore(wasm: string): Promise<Core>;
	/** Standard output: the JSON and nothing else. */
	print(text: string): void;
	/** Standard error, a line. */
	say(line: string): void;
}
