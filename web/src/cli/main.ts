/** `npm run -s grow -- …`, bundled for Node by wasm-core/tools/grow.mjs. Does its work when it is loaded. */
import { readFile, writeFile } from "node:fs/promises";
import { loadCoreFromBytes } from "../core/loader";
import { run } from "./run";

// The bundle lies as deep in the repository as this file, so the way to the core is the same from both.
const corePath = new URL("../../../build/core/bunch.wasm", import.meta.url);

async function coreBytes(): Promise<Uint8Array<ArrayBuffer>> {
	return readFile(corePath).catch(() => {
		throw new Error("build/core/bunch.wasm is missing; npm run core builds it");
	});
}

// A reader that has seen enough (`| head`) is no error.
process.stdout.on("error", (error: NodeJS.ErrnoException) => {
	if (error.code !== "EPIPE") throw error;
});

process.exitCode = await run(process.argv.slice(2), {
	readFile,
	writeFile,
	loadCore: async () => loadCoreFromBytes(await coreBytes()),
	print: (text) => process.stdout.write(text),
	say: (line) => process.stderr.write(`${line}\n`),
});
