import { expect } from "vitest";
import { run } from "../../../web/src/cli/run";
import type { Surroundings } from "../../../web/src/cli/surroundings";
import { freshCore } from "../core/wasm";

/** Surroundings that keep everything in memory. */
export function memoryWorld(files: Record<string, string | Uint8Array> = {}) {
	const written = new Map<string, string | Uint8Array>();
	const printed: string[] = [];
	const said: string[] = [];
	const missing = (path: string) => Object.assign(new Error(`ENOENT: ${path}`), { code: "ENOENT" });
	const world: Surroundings = {
		readFile: async (path) => {
			const data = files[path];
			if (data === undefined) throw missing(path);
			return typeof data === "string" ? new TextEncoder().encode(data) : data;
		},
		writeFile: async (path, data) => {
			if (path.startsWith("nowhere/")) throw missing(path);
			written.set(path, data);
		},
		loadCore: freshCore,
		print: (text) => printed.push(text),
		say: (line) => said.push(line),
	};
	return { world, written, printed, said };
}

/** Runs the command in such surroundings. */
export async function grow(words: string[], files?: Parameters<typeof memoryWorld>[0]) {
	const memory = memoryWorld(files);
	const status = await run(words, memory.world);
	const [text = ""] = memory.printed;
	return { status, ...memory, json: text.startsWith("{") ? JSON.parse(text) : undefined };
}

/** The one line that a call which cannot be used leaves on standard error. */
export async function complaint(words: string[], files?: Parameters<typeof memoryWorld>[0]): Promise<string> {
	const { status, said, printed, written } = await grow(words, files);
	expect(status).toBe(2);
	expect(printed).toEqual([]);
	expect(written.size).toBe(0);
	expect(said).toHaveLength(1);
	expect(said[0]).toMatch(/^grow: [^\n]{1,240}$/);
	return said[0].slice("grow: ".length);
}
