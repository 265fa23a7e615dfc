/**
 * `npm run service`: the service under Node, bundled into one file by wasm-core/tools/service.mjs. Loading it starts
 * the server.
 */
import { availableParallelism } from "node:os";
import { parseArgs } from "node:util";
import { isMainThread, Worker } from "node:worker_threads";
import { version } from "../../../../package.json";
import { makeServer } from "./server";
import { answerRequests } from "./thread";
import { ThreadPool } from "./thread_pool";

/** The most memory for the JavaScript objects of one thread, MiB; a thread that needs more is replaced. */
const HEAP = 1024;
/** Bytes of memory after a request above which a thread is replaced: an instance of WebAssembly never shrinks. */
const MOST_HEAP_BYTES = 256 * 1024 * 1024;
const USAGE = `npm run service -- [--port 8765] [--host 127.0.0.1] [--threads N] [--seconds 20]
Serves /specimens/PRESET.ENDING?…, the plant's file, with N threads and at most the given seconds for one plant.
--host 0.0.0.0 accepts requests from other machines.
`;

if (isMainThread) await serve();
else answerRequests(version);

async function serve(): Promise<void> {
	const { port, host, threads, seconds, help } = options();
	if (help) {
		process.stdout.write(USAGE);
		return;
	}
	const own = new URL(import.meta.url);
	const pool = new ThreadPool({
		start: () => new Worker(own, { resourceLimits: { maxOldGenerationSizeMb: HEAP } }),
		threads: number("threads", threads, availableParallelism(), 1, 256),
		timeout: 1000 * number("seconds", seconds, 20, 0.1, 3600),
		queueLength: 256,
		mostHeapBytes: MOST_HEAP_BYTES,
	});
	const server = makeServer(pool);
	server.on("error", ({ message }) => {
		process.stderr.write(`service: ${message}\n`);
		process.exitCode = 1;
		void pool.close();
	});
	server.listen(number("port", port, 8765, 0, 65535), host, () => {
		const address = server.address();
		const at = typeof address === "object" && address ? address.port : address;
		process.stdout.write(`Specimens at http://${host}:${at}/specimens/\n`);
	});
	let draining = false;
	const end = async () => {
		// A second signal does not wait for pending answers.
		if (draining) return process.exit(1);
		draining = true;
		server.close();
		server.closeIdleConnections();
		await pool.drain();
	};
	process.on("SIGINT", end);
	process.on("SIGTERM", end);
}

function options() {
	try {
		const text = { type: "string" } as const;
		const { values } = parseArgs({
			options: { port: text, host: text, threads: text, seconds: text, help: { type: "boolean", short: "h" } },
		});
		return { host: "127.0.0.1", ...values };
	} catch (error) {
		return refuse((error as Error).message.split("\n")[0]);
	}
}

function number(name: string, text: string | undefined, otherwise: number, least: number, most: number): number {
	if (text === undefined) return otherwise;
	const value = text.trim() === "" ? Number.NaN : Number(text);
	if (value >= least && value <= most && (name === "seconds" || Number.isInteger(value))) return value;
	return refuse(`--${name} ${text}: a number from ${least} to ${most}`);
}

function refuse(why: string): never {
	process.stderr.write(`service: ${why}\n${USAGE}`);
	process.exit(2);
}
