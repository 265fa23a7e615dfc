import { EventEmitter } from "node:events";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { ThreadRequest, ThreadResponse } from "../../../../web/src/service/node/messages";
import { type Thread, ThreadPool } from "../../../../web/src/service/node/thread_pool";

/** A thread that answers when a test calls `answer`. */
class Slow extends EventEmitter {
	readonly requests: ThreadRequest[] = [];
	ended = false;
	postMessage(request: ThreadRequest) {
		this.requests.push(request);
	}
	answer(heapBytes = 0) {
		const { id } = this.requests[this.requests.length - 1];
		this.emit("message", { id, status: 200, headers: {}, body: new Uint8Array(), heapBytes } satisfies ThreadResponse);
	}
	async terminate() {
		this.ended = true;
		this.emit("exit");
	}
}

// A request that is never answered fails its test soon.
vi.setConfig({ testTimeout: 10_000 });

let started: Slow[];
let threads: ThreadPool;
beforeEach(() => {
	vi.useFakeTimers();
	started = [];
	threads = poolOf(2);
});
afterEach(() => vi.useRealTimers());

function poolOf(queueLength: number): ThreadPool {
	const start = () => {
		const thread = new Slow();
		started.push(thread);
		return thread as unknown as Thread;
	};
	return new ThreadPool({ start, threads: 2, timeout: 1000, queueLength, mostHeapBytes: 100 });
}
const run = (url: string, signal?: AbortSignal) => threads.run({ url, method: "GET", headers: {} }, signal);
const urls = () => started.map(({ requests }) => requests.map(({ url }) => url));

it("runs one request a thread, and queues the rest", async () => {
	const answers = [run("a"), run("b"), run("c")];
	expect(urls()).toEqual([["a"], ["b"]]);
	started[1].answer();
	expect(urls()).toEqual([["a"], ["b", "c"]]);
	started[0].answer();
	started[1].answer();
	expect((await Promise.all(answers)).map(({ status }) => status)).toEqual([200, 200, 200]);
	expect(started).toHaveLength(2);
});

it("ends a thread that holds too much memory after its answer, and gives the next request a new one", async () => {
	const answers = [run("large"), run("b"), run("c")];
	started[0].answer(101);
	expect((await answers[0]).status).toBe(200);
	expect(urls()).toEqual([["large"], ["b"], ["c"]]);
	started[1].answer(100);
	started[2].answer();
	await Promise.all(answers);
	expect(started.map(({ ended }) => ended)).toEqual([true, false, false]);
	// An idle thread that has ended is replaced only when a request needs it.
	const last = run("d");
	started[2].answer(101);
	await last;
	expect(started.map(({ ended }) => ended)).toEqual([true, false, true]);
});

it("refuses a request at once where the queue is full", async () => {
	const answers = [run("a"), run("b"), run("c"), run("d")];
	await expect(run("e")).rejects.toMatchObject({ status: 503, headers: { "retry-after": "5" } });
	const done = Promise.allSettled(answers);
	await threads.close();
	expect((await done).map(({ status }) => status)).toEqual(["rejected", "rejected", "rejected", "rejected"]);
	// Requests of the queue start no thread when the pool closes.
	expect(started).toHaveLength(2);
	await expect(run("f")).rejects.toMatchObject({
		status: 503,
		message: "The service is shutting down. Try again in a moment.",
	});
});

it("ends a thread whose request takes too long, and starts another", async () => {
	const slow = run("slow");
	const next = [run("b"), run("c")];
	const refused = expect(slow).rejects.toMatchObject({
		status: 503,
		message: expect.stringContaining("longer than 1 s"),
	});
	vi.advanceTimersByTime(999);
	expect(started[0].ended).toBe(false);
	started[1].answer();
	started[1].answer();
	vi.advanceTimersByTime(1);
	await refused;
	expect([started[0].ended, started[1].ended]).toEqual([true, false]);
	await Promise.all(next);
	const later = run("d");
	expect(urls()).toEqual([["slow"], ["b", "c"], ["d"]]);
	started[2].answer();
	expect((await later).status).toBe(200);
	// The timer of an answered request has been cleared.
	vi.advanceTimersByTime(10_000);
	expect(started[2].ended).toBe(false);
});

it("refuses a request whose thread fails", async () => {
	const answer = run("a");
	started[0].emit("error", new Error("out of memory"));
	await expect(answer).rejects.toMatchObject({ status: 503, message: expect.stringContaining("Internal error") });
});

it("takes a request out of the queue when its client leaves", async () => {
	const clients = Array.from({ length: 2 }, () => new AbortController());
	const answers = [run("a"), run("b"), ...clients.map(({ signal }, n) => run(`left ${n}`, signal))];
	const left = expect(Promise.all(answers.slice(2))).rejects.toMatchObject({ message: "The client has disconnected." });
	const settled = Promise.allSettled(answers);
	for (const client of clients) client.abort();
	await left;
	const next = run("c");
	started[0].answer();
	expect(urls()).toEqual([["a", "c"], ["b"]]);
	started[0].answer();
	started[1].answer();
	await next;
	expect((await settled).map(({ status }) => status)).toEqual(["fulfilled", "fulfilled", "rejected", "rejected"]);
});

it("ends a growth soon after its client has left, and keeps the thread of one that is done before", async () => {
	const clients = Array.from({ length: 2 }, () => new AbortController());
	const [long, short] = clients.map(({ signal }, n) => run(`${n}`, signal));
	const refused = expect(long).rejects.toMatchObject({ message: "The client has disconnected." });
	for (const client of clients) client.abort();
	vi.advanceTimersByTime(499);
	started[1].answer();
	await short;
	vi.advanceTimersByTime(1);
	await refused;
	expect(started.map(({ ended }) => ended)).toEqual([true, false]);
});

it("refuses a request that has waited as long as one growth may take", async () => {
	threads = poolOf(3);
	const first = [run("a"), run("b")];
	const then = [run("c"), run("d")];
	const refused = expect(run("e")).rejects.toMatchObject({ status: 503, headers: { "retry-after": "5" } });
	vi.advanceTimersByTime(900);
	for (const thread of started) thread.answer();
	await Promise.all(first);
	vi.advanceTimersByTime(100);
	await refused;
	for (const thread of started) thread.answer();
	await Promise.all(then);
	expect(urls()).toEqual([
		["a", "c"],
		["b", "d"],
	]);
});

it("answers what is here before it closes, and refuses what comes later", async () => {
	const answers = [run("a"), run("b"), run("c")];
	const drained = threads.drain();
	await expect(run("d")).rejects.toMatchObject({
		status: 503,
		message: "The service is shutting down. Try again in a moment.",
	});
	started[0].answer();
	started[0].answer();
	started[1].answer();
	expect((await Promise.all(answers)).map(({ status }) => status)).toEqual([200, 200, 200]);
	await drained;
	expect(started.map(({ ended }) => ended)).toEqual([true, true]);
});
