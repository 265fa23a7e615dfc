/** `npm run -s grow -- …`, bundled for Node by wasm-core/tools/grow.mjs. Loading it runs the command. */
import { readFile } from "node:fs/promises";
import { loadCoreFromBytes } from "../core/loader";
import { MessageError } from "../locale/message_error";
import { text } from "./messages.generated";
import { nodeFiles } from "./node_files";
import { run } from "./run";
import { reasonOf } from "./writing";

// The bundle is as deep in the repository as this file: the path to the cores is the same from both.
const cores = new URL("../../../build/core/", import.meta.url);

/** Reads the built core of a model; `wasm` is its file's name. */
async function coreBytes(wasm: string): Promise<Uint8Array<ArrayBuffer>> {
	return readFile(new URL(wasm, cores)).catch(() => {
		throw new MessageError(text.message("core_missing", { file: wasm }));
	});
}

// A reader that closes early (`
// head`) is no error.
process.stdout.on("error", (error: NodeJS.ErrnoException) => {
	if (error.code === "EPIPE") return;
	const problem = text("output_not_written", { reason: reasonOf(error).text });
	process.stderr.write(`${text("error", { problem })}\n`);
	process.exit(1);
});

process.exitCode = await run(process.argv.slice(2), {
	...nodeFiles,
	environment: process.env,
	loadCore: async (wasm, timePassed) => loadCoreFromBytes(await coreBytes(wasm), timePassed),
	print: (text) => void process.stdout.write(text),
	printError: (line) => process.stderr.write(`${line}\n`),
});
