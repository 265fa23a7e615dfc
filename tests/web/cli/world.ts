import { expect } from "vitest";
import { run } from "../../../web/src/cli/run";
import type { CommandEnvironment } from "../../../web/src/cli/surroundings";
import { loadCoreFromBytes } from "../../../web/src/core/loader";
import { wasmBytes } from "../core/wasm";

/** Numbers of processes: each world is another one, and all run on one machine. */
let processes = 100;

/**
 * Surroundings that keep everything in memory.
 * @param environment variables by name
 * @param written the files written; several worlds may share them
 */
export function memoryWorld(
	files: Record<string, string | Uint8Array> = {},
	environment: CommandEnvironment["environment"] = {},
	written = new Map<string, string | Uint8Array>(),
) {
	const printed: string[] = [];
	const messages: string[] = [];
	const missing = (path: string) => Object.assign(new Error(`ENOENT: ${path}`), { code: "ENOENT" });
	const world: CommandEnvironment = {
		readFile: async (path) => {
			const data = files[path] ?? written.get(path);
			if (data === undefined) throw missing(path);
			return typeof data === "string" ? new TextEncoder().encode(data) : data;
		},
		writeFile: async (path, data) => {
			if (path.startsWith("nowhere/")) throw missing(path);
			// Only text is written in pieces.
			written.set(path, isPieces(data) ? new TextDecoder().decode(Buffer.concat(data)) : data);
		},
		replaceFile: async (path, data) => world.writeFile(path, data),
		createFile: async (path, data) => {
			if (files[path] !== undefined || written.has(path)) return false;
			await world.writeFile(path, data);
			return true;
		},
		appendFile: async (path, text) => world.writeFile(path, `${written.get(path) ?? ""}${text}`),
		removeFile: async (path) => void written.delete(path),
		makeFolder: async () => {},
		listFolder: async (folder) => {
			const names = [...Object.keys(files), ...written.keys()].map((path) => path.split("/"));
			const inside = folder === "." ? names : names.filter(([first]) => first === folder).map((path) => path.slice(1));
			return inside.map(([name]) => name);
		},
		host: "here",
		process: ++processes,
		isRunning: () => true,
		now: () => 1_000_000,
		elapsed: () => 0,
		whenTerminated: () => () => {},
		environment,
		loadCore: async (wasm, timePassed) => loadCoreFromBytes(await wasmBytes(wasm), timePassed),
		// Pieces are printed one after the other, as if they were one text.
		print: (text) => {
			if (typeof text === "string") printed.push(text);
			else printed.push(`${printed.pop() ?? ""}${new TextDecoder().decode(text)}`);
		},
		printError: (line) => messages.push(line),
	};
	return { world, written, printed, messages };
}

/** Runs the command in such surroundings. */
export async function grow(words: string[], ...world: Parameters<typeof memoryWorld>) {
	const memory = memoryWorld(...world);
	const status = await run(words, memory.world);
	const [text = ""] = memory.printed;
	return { status, ...memory, json: text.startsWith("{") ? JSON.parse(text) : undefined };
}

/** The one line that a call which cannot be used leaves on standard error. */
export async function complaint(words: string[], ...world: Parameters<typeof memoryWorld>): Promise<string> {
	const { status, messages, printed, written } = await grow(words, ...world);
	expect(status).toBe(2);
	expect(printed).toEqual([]);
	expect(written.size).toBe(0);
	expect(messages).toHaveLength(1);
	// Below it stands at most a line of a text, and the place in it.
	expect(messages[0]).toMatch(/^grow: [^\n]{1,240}(\n {2}[^\n]+\n\s*\^)?$/);
	return messages[0].slice("grow: ".length);
}

const isPieces = (data: string | Uint8Array | readonly Uint8Array[]): data is readonly Uint8Array[] =>
	Array.isArray(data);
