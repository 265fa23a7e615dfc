/**
 * `npm run bench -- soak [REQUESTS]` (default 100,000), also a stage of the long test run: memory of the model service. The service
 * runs with its threads and its HTTP on loopback and receives requests for plants of every model in every kind of file, and many that
 * it must refuse. The same 4,000 addresses are requested again and again; after all of them have been requested twice, no memory may
 * grow: not that of the cores, nor a heap, nor that of the process.
 */
import { once } from "node:events";
import { Agent, request } from "node:http";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { MessageChannel, Worker } from "node:worker_threads";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { bundleForNode } from "../../wasm-core/tools/node_bundle.mjs";
import { buildFolder } from "../../wasm-core/tools/repository.mjs";
import { soakRequest } from "./soak_requests.mjs";
import { printTable } from "./statistics.mjs";
import { grown } from "./steady.mjs";

/** How many addresses there are. */
const ADDRESSES = 4000;
const THREADS = 2;
const SAMPLES = 25;

/** Default of `soak`. */
const REQUESTS = 100_000;

/**
 * @typedef {object} Service the running service, with its measurements
 * @property {(request: { path: string }) => Promise<number>} send the status of an answer, which is read to its end
 * @property {(requests: number) => Promise<Sample>} sample
 * @property {() => Promise<void>} close
 *
 * @typedef {{ requests: number, cores: number, threads: number, server: number, process: number }} Sample memory in MB after a
 * number of requests: of the cores, of the heaps of the threads, of the heap of the server, and of the process
 */

/** @returns {Promise<Service>} */
async function startService() {
	setFlagsFromString("--expose-gc");
	const collect = runInNewContext("gc");
	await buildCore();
	const folder = join(buildFolder, "node/soak");
	const rooms = { server: "server.ts", threads: "thread_pool.ts", thread: "thread.ts" };
	await bundleForNode(
		Object.fromEntries(Object.entries(rooms).map(([name, path]) => [name, `service/node/${path}`])),
		folder,
	);
	const at = (name) => pathToFileURL(join(folder, `${name}.mjs`)).href;
	const [{ makeServer }, { ThreadPool }] = [await import(at("server")), await import(at("threads"))];

	/** Ports to the threads that report their memory. */
	const watched = new Set();
	function start() {
		const { port1: ours, port2: theirs } = new MessageChannel();
		const workerData = { program: at("thread"), port: theirs };
		const thread = new Worker(new URL("soak_thread.mjs", import.meta.url), { workerData, transferList: [theirs] });
		watched.add(ours);
		thread.once("exit", () => watched.delete(ours));
		return thread;
	}

	const pool = new ThreadPool({ start, threads: THREADS, timeout: 120_000, queueLength: 64 });
	const server = makeServer(pool).listen(0, "127.0.0.1");
	await once(server, "listening");
	// A sample can take longer than the server waits for the next request of a connection.
	server.keepAliveTimeout = 0;
	const agent = new Agent({ keepAlive: true, maxSockets: 2 * THREADS });
	return {
		send: ({ path, ...options }) =>
			new Promise((resolve, reject) => {
				const { port } = server.address();
				const outgoing = request({ agent, host: "127.0.0.1", port, path, ...options }, (answer) => {
					answer.resume().on("end", () => resolve(answer.statusCode));
				});
				outgoing.on("error", reject).end();
			}),
		async sample(requests) {
			const held = await Promise.all(
				[...watched].map(async (port) => {
					port.postMessage("measure");
					const [{ cores, heap }] = await once(port, "message");
					return { cores, heap };
				}),
			);
			collect();
			const { heapUsed, rss } = process.memoryUsage();
			const sum = (key) => held.reduce((all, each) => all + each[key], 0) / 1e6;
			return { requests, cores: sum("cores"), threads: sum("heap"), server: heapUsed / 1e6, process: rss / 1e6 };
		},
		async close() {
			for (const port of watched) port.close();
			agent.destroy();
			server.close();
			await pool.close();
		},
	};
}

/**
 * Runs the service through `requests` requests and prints its memory on the way.
 *
 * @param {number | string} [requests]
 * @returns {Promise<{ passed: number, failed: number }>} two checks: no memory grows, and no answer is an internal error
 */
export async function soak(requests = REQUESTS) {
	const total = Number(requests);
	if (!(total >= 6 * ADDRESSES)) {
		console.error(
			`soak: ${requests} is too few; it takes ${6 * ADDRESSES} or more, several for each of ${ADDRESSES} addresses`,
		);
		return { passed: 0, failed: 1 };
	}
	const service = await startService();
	const statuses = new Map();
	const samples = [];
	let next = 0;
	const sendUntil = async (end) => {
		while (next < end) {
			const status = await service.send(soakRequest(next++ % ADDRESSES));
			statuses.set(status, (statuses.get(status) ?? 0) + 1);
		}
	};
	for (let part = 1; part <= SAMPLES; part++) {
		const end = Math.round((total * part) / SAMPLES);
		await Promise.all(Array.from({ length: 2 * THREADS }, () => sendUntil(end)));
		samples.push(await service.sample(next));
		process.stderr.write(`${next} of ${total}: ${JSON.stringify(samples.at(-1))}\n`);
	}
	await service.close();

	const answered = [...statuses].sort(([a], [b]) => a - b).map(([status, count]) => `${status}: ${count}`);
	console.log(`\n${total} requests answered by ${THREADS} threads; ${answered.join(", ")}`);
	return verdict(samples, [...statuses.keys()]);
}

/** Prints the samples and problems with them. */
function verdict(samples, statuses) {
	const keys = ["cores", "threads", "server", "process"];
	printTable("Memory held after collecting, MB", [
		["requests", "cores", "threads’ heaps", "server’s heap", "process"],
		...samples.map((each) => [each.requests, ...keys.map((key) => each[key].toFixed(1))]),
	]);
	const settled = samples.filter(({ requests }) => requests >= 2 * ADDRESSES);
	const growing = keys.filter((key) => grown(settled.map((each) => each[key])));
	const broken = statuses.filter((status) => status >= 500 && status !== 501);
	if (growing.length > 0) console.error(`Memory grows with the requests: ${growing.join(", ")}.`);
	if (broken.length > 0) console.error(`Internal errors were answered: ${broken.join(", ")}.`);
	const failed = Number(growing.length > 0) + Number(broken.length > 0);
	if (failed === 0) console.log("No memory grew.");
	return { passed: 2 - failed, failed };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const { failed } = await soak(process.argv[2]);
	if (failed > 0) process.exitCode = 1;
}
