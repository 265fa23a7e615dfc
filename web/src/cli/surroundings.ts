import type { Core, TimePassed } from "../core/core";

/** What the command needs of the world outside; tests give it another. */
export interface Surroundings {
	readFile(path: string): Promise<Uint8Array>;
	/** Data in pieces is written one after the other. */
	writeFile(path: string, data: string | Uint8Array | readonly Uint8Array[]): Promise<void>;
	/** Writes a file that is whole or not there under its name, whatever happens meanwhile. */
	replaceFile(path: string, data: string | Uint8Array): Promise<void>;
	/** Writes a whole file where there is none under its name. @returns whether it did; of several at once one does */
	createFile(path: string, data: string): Promise<boolean>;
	appendFile(path: string, text: string): Promise<void>;
	/** One that is not there is no error. */
	removeFile(path: string): Promise<void>;
	/** With those above it; one that is there is no error. */
	makeFolder(path: string): Promise<void>;
	/** Names of what is in a folder, in any order. */
	listFolder(path: string): Promise<string[]>;
	/** The name of this machine. */
	readonly host: string;
	/** The number of this process. */
	readonly process: number;
	/** Whether a process of this machine runs, by its number. */
	isRunning(process: number): boolean;
	/** Milliseconds since 1970. */
	now(): number;
	/** Milliseconds from any moment on, by a clock that is never set. */
	elapsed(): number;
	/** Runs work before the process ends by a signal (SIGTERM). @returns a function that cancels it */
	whenTerminated(work: () => Promise<void>): () => void;
	/** Variables by name. */
	readonly environment: Readonly<Record<string, string | undefined>>;
	/**
	 * @param wasm the file of a model's core: `bunch.wasm`
	 * @param timePassed as of `Core.instantiate`; no time limit where absent
	 */
	loadCore(wasm: string, timePassed?: TimePassed): Promise<Core>;
	/** Standard output: the JSON and nothing else. */
	print(text: string | Uint8Array): void;
	/** Standard error, a line. */
	say(line: string): void;
}
