import type { Core } from "../core/core";

/** What the command needs of the world outside; tests give it another. */
export interface Surroundings {
	readFile(path: string): Promise<Uint8Array>;
	writeFile(path: string, data: string | Uint8Array): Promise<void>;
	loadCore(): Promise<Core>;
	/** Standard output: the JSON and nothing else. */
	print(text: string): void;
	/** Standard error, a line. */
	say(line: string): void;
}
