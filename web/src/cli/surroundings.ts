import type { Core } from "../core/core";

/** What the command needs of the world outside; tests give it another. */
export interface Surroundings {
	readFile(path: string): Promise<Uint8Array>;
	writeFile(path: string, data: string | Uint8Array): Promise<void>;
	/** @param wasm the file of a model's core: `bunch.wasm` */
	loadCore(wasm: string): Promise<Core>;
	/** Standard output: the JSON and nothing else. */
	print(text: string): void;
	/** Standard error, a line. */
	say(line: string): void;
}
