import type { Core, TimePassed } from "../core/core";

/** The environment of the command: files, processes and output. Tests replace it. */
export interface CommandEnvironment {
	readFile(path: string): Promise<Uint8Array>;
	/** Data in pieces is written one after the other. */
	writeFile(path: string, data: string | Uint8Array | readonly Uint8Array[]): Promise<void>;
	/** Replaces a file atomically. */
	replaceFile(path: string, data: string | Uint8Array): Promise<void>;
	/**
	 * Creates a file atomically, unless it exists.
	 * @returns whether it was created; of several calls at once, one creates it
	 */
	createFile(path: string, data: string): Promise<boolean>;
	appendFile(path: string, text: string): Promise<void>;
	/** A missing file is no error. */
	removeFile(path: string): Promise<void>;
	/** Makes a folder and its parents; an existing one is no error. */
	makeFolder(path: string): Promise<void>;
	/** Names of the entries of a folder, in any order. */
	listFolder(path: string): Promise<string[]>;
	/** The name of this machine. */
	readonly host: string;
	/** The number of this process. */
	readonly process: number;
	/** Whether a process of this machine runs, by its number. */
	isRunning(process: number): boolean;
	/** Milliseconds since 1970. */
	now(): number;
	/** Milliseconds of a monotonic clock. */
	elapsed(): number;
	/**
	 * Runs work before a signal (SIGTERM) ends the process.
	 * @returns a function that cancels it
	 */
	whenTerminated(work: () => Promise<void>): () => void;
	/** Environment variables by name. */
	readonly environment: Readonly<Record<string, string | undefined>>;
	/**
	 * @param wasm the file of a model's core: `bunch.wasm`
	 * @param timePassed as in `Core.instantiate`; no time limit where absent
	 */
	loadCore(wasm: string, timePassed?: TimePassed): Promise<Core>;
	/** Writes to standard output: only the JSON. */
	print(text: string | Uint8Array): void;
	/** Writes a line to standard error. */
	printError(line: string): void;
}
