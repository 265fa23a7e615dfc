/**
 * `npm run service`: the service under Node, bundled into one file by wasm-core/tools/service.mjs. Loading it starts
 * the server.
 */
import { availableParallelism } from "node:os";
import { parseArgs } from "node:util";
import { isMainThread, Worker } from "node:worker_threads";
import { version } from "../../../../package.json";
import { text } from "../messages.generated";
import { makeServer } from "./server";
import { answerRequests } from "./thread";
import { ThreadPool } from "./thread_pool";

/** The most memory for the JavaScript objects of one thread, MiB; a thread that needs more is replaced. */
const HEAP = 1024;
/** Bytes of memory after a request above which a thread is replaced: an instance of WebAssembly never shrinks. */
const MAX_HEAP_BYTES = 256 * 1024 * 1024;

if (isMainThread) await serve();
else answerRequests(version);

/**
 * Starts the server by the command line's options. The first SIGINT or SIGTERM lets pending answers finish, the second
 * ends at once.
 */
async function serve(): Promise<void> {
	const { port, host, threads, seconds, help } = options();
	if (help) {
		process.stdout.write(`${text("usage")}\n`);
		return;
	}
	const own = new URL(import.meta.url);
	const pool = new ThreadPool({
		start: () => new Worker(own, { resourceLimits: { maxOldGenerationSizeMb: HEAP } }),
		threads: number("threads", threads, availableParallelism(), 1, 256),
		timeout: 1000 * number("seconds", seconds, 20, 0.1, 3600),
		queueLength: 256,
		mostHeapBytes: MAX_HEAP_BYTES,
	});
	const server = makeServer(pool);
	server.on("error", ({ message }) => {
		process.stderr.write(`${text("program_error", { problem: message })}\n`);
		process.exitCode = 1;
		void pool.close();
	});
	server.listen(number("port", port, 8765, 0, 65535), host, () => {
		const address = server.address();
		const at = typeof address === "object" && address ? address.port : address;
		process.stdout.write(`${text("listening", { address: `http://${host}:${at}/specimens/` })}\n`);
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

/** Parses the command line, without checking the numbers. */
function options() {
	try {
		const value = { type: "string" } as const;
		const { values } = parseArgs({
			options: { port: value, host: value, threads: value, seconds: value, help: { type: "boolean", short: "h" } },
		});
		return { host: "127.0.0.1", ...values };
	} catch (error) {
		return refuse((error as Error).message.split("\n")[0]);
	}
}

/**
 * Reads the number of an option, or ends the program with a message.
 * @param written the option's text; undefined without the option
 * @param otherwise the number without the option
 */
function number(option: string, written: string | undefined, otherwise: number, least: number, most: number): number {
	if (written === undefined) return otherwise;
	const value = written.trim() === "" ? Number.NaN : Number(written);
	if (value >= least && value <= most && (option === "seconds" || Number.isInteger(value))) return value;
	return refuse(text("option_out_of_range", { option, value: written, least: String(least), most: String(most) }));
}

/** Prints an error of the call and the usage, and ends the program with status 2. */
function refuse(why: string): never {
	process.stderr.write(`${text("program_error", { problem: why })}\n${text("usage")}\n`);
	process.exit(2);
}
