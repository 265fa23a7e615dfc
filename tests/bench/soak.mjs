/**
 * `npm run soak -- [REQUESTS]` (100,000): the model service as it runs, its threads and its HTTP on loopback, is asked for plants of every
 * model in every kind of file, and for much that is refused. The same few thousand addresses are asked over and over; once all have been
 * asked twice, nothing may grow: not the memory of the cores, nor any heap, nor the process. Fails where one does.
 */
import { once } from "node:events";
import { Agent, request } from "node:http";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { MessageChannel, Worker } from "node:worker_threads";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { bundleForNode } from "../../wasm-core/tools/node_bundle.mjs";
import { buildFolder } from "../../wasm-core/tools/repository.mjs";
import { soakQuestion } from "./soak_questions.mjs";
import { printTable } from "./statistics.mjs";
import { grown } from "./steady.mjs";

/** How many addresses there are. */
const ADDRESSES = 4000;
const THREADS = 2;
const SAMPLES = 25;

const requests = Number(process.argv[2] ?? 100_000);
if (!(requests >= 6 * ADDRESSES)) {
	console.error(
		`npm run soak -- [REQUESTS]: ${6 * ADDRESSES} or more, for each of ${ADDRESSES} addresses is asked some times`,
	);
	process.exit(2);
}
setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc");

await buildCore();
const folder = join(buildFolder, "node/soak");
const rooms = { server: "server.ts", threads: "threads.ts", thread: "thread.ts" };
await bundleForNode(
	Object.fromEntries(Object.entries(rooms).map(([name, path]) => [name, `service/node/${path}`])),
	folder,
);
const at = (name) => pathToFileURL(join(folder, `${name}.mjs`)).href;
const [{ makeServer }, { Threads }] = [await import(at("server")), await import(at("threads"))];

/** Asks a thread what it holds. */
const watched = new Set();
function start() {
	const { port1: ours, port2: theirs } = new MessageChannel();
	const workerData = { program: at("thread"), port: theirs };
	const thread = new Worker(new URL("soak_thread.mjs", import.meta.url), { workerData, transferList: [theirs] });
	watched.add(ours);
	thread.once("exit", () => watched.delete(ours));
	return thread;
}

async function sample(asked) {
	const held = await Promise.all(
		[...watched].map(async (port) => {
			port.postMessage("weigh");
			const [{ cores, heap }] = await once(port, "message");
			return { cores, heap };
		}),
	);
	collect();
	const { heapUsed, rss } = process.memoryUsage();
	const sum = (key) => held.reduce((all, each) => all + each[key], 0) / 1e6;
	return { asked, cores: sum("cores"), threads: sum("heap"), server: heapUsed / 1e6, process: rss / 1e6 };
}

const pool = new Threads({ start, threads: THREADS, patience: 120_000, waiting: 64 });
const server = makeServer(pool).listen(0, "127.0.0.1");
await once(server, "listening");
const agent = new Agent({ keepAlive: true, maxSockets: 2 * THREADS });

/** The status of an answer, which is read to its end. */
function ask({ path, ...options }) {
	return new Promise((resolve, reject) => {
		const { port } = server.address();
		const asking = request({ agent, host: "127.0.0.1", port, path, ...options }, (answer) => {
			answer.resume().on("end", () => resolve(answer.statusCode));
		});
		asking.on("error", reject).end();
	});
}

const statuses = new Map();
const samples = [];
let next = 0;
async function askUntil(end) {
	while (next < end) {
		const status = await ask(soakQuestion(next++ % ADDRESSES));
		statuses.set(status, (statuses.get(status) ?? 0) + 1);
	}
}
for (let part = 1; part <= SAMPLES; part++) {
	const end = Math.round((requests * part) / SAMPLES);
	await Promise.all(Array.from({ length: 2 * THREADS }, () => askUntil(end)));
	samples.push(await sample(next));
	process.stderr.write(`${next} of ${requests}: ${JSON.stringify(samples.at(-1))}\n`);
}
for (const port of watched) port.close();
agent.destroy();
server.close();
await pool.close();

const answered = [...statuses].sort(([a], [b]) => a - b).map(([status, count]) => `${status}: ${count}`);
console.log(`\n${requests} requests answered by ${THREADS} threads; ${answered.join(", ")}`);
const keys = ["cores", "threads", "server", "process"];
printTable("Memory held after collecting, MB", [
	["requests", "cores", "threads’ heaps", "server’s heap", "process"],
	...samples.map((each) => [each.asked, ...keys.map((key) => each[key].toFixed(1))]),
]);
const settled = samples.filter(({ asked }) => asked >= 2 * ADDRESSES);
const growing = keys.filter((key) => grown(settled.map((each) => each[key])));
const broken = [...statuses.keys()].filter((status) => status >= 500 && status !== 501);
if (growing.length > 0) console.error(`Grows with the requests: ${growing.join(", ")}.`);
if (broken.length > 0) console.error(`There were answers that nobody should get: ${broken.join(", ")}.`);
if (growing.length + broken.length > 0) process.exitCode = 1;
else console.log("Nothing grew.");
