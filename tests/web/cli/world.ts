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
