import { EventEmitter } from "node:events";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Question, Reply } from "../../../../web/src/service/node/messages";
import { type Thread, Threads } from "../../../../web/src/service/node/threads";

/** A thread that answers when it is told to. */
class Slow extends EventEmitter {
	readonly asked: Question[] = [];
	ended = false;
	postMessage(question: Question) {
		this.asked.push(question);
	}
	answer() {
		const { id } = this.asked[this.asked.length - 1];
		this.emit("message", { id, status: 200, headers: {}, body: new Uint8Array() } satisfies Reply);
	}
	async terminate() {
		this.ended = true;
		this.emit("exit");
	}
}

let started: Slow[];
let threads: Threads;
beforeEach(() => {
	vi.useFakeTimers();
	started = [];
	const start = () => {
		const thread = new Slow();
		started.push(thread);
		return thread as unknown as Thread;
	};
	threads = new Threads({ start, threads: 2, patience: 1000, waiting: 2 });
});
afterEach(() => vi.useRealTimers());

const ask = (url: string) => threads.ask({ url, method: "GET", headers: {} });
const urls = () => started.map(({ asked }) => asked.map(({ url }) => url));

it("asks as many at once as there are threads, the rest in turn", async () => {
	const answers = [ask("a"), ask("b"), ask("c")];
	expect(urls()).toEqual([["a"], ["b"]]);
	started[1].answer();
	expect(urls()).toEqual([["a"], ["b", "c"]]);
	started[0].answer();
	started[1].answer();
	expect((await Promise.all(answers)).map(({ status }) => status)).toEqual([200, 200, 200]);
	expect(started).toHaveLength(2);
});

it("refuses more than may wait, at once", async () => {
	const answers = [ask("a"), ask("b"), ask("c"), ask("d")];
	await expect(ask("e")).rejects.toMatchObject({ status: 503, headers: { "retry-after": "5" } });
	const done = Promise.allSettled(answers);
	await threads.close();
	expect((await done).map(({ status }) => status)).toEqual(["rejected", "rejected", "rejected", "rejected"]);
	// Those who waited begin no thread that nobody would end.
	expect(started).toHaveLength(2);
	await expect(ask("f")).rejects.toMatchObject({ status: 503, message: "the service ends" });
});

it("ends a thread that takes too long, and goes on with another", async () => {
	const slow = ask("slow");
	const next = [ask("b"), ask("c")];
	const told = expect(slow).rejects.toMatchObject({ status: 503, message: expect.stringContaining("more than 1 s") });
	vi.advanceTimersByTime(999);
	expect(started[0].ended).toBe(false);
	started[1].answer();
	started[1].answer();
	vi.advanceTimersByTime(1);
	await told;
	expect([started[0].ended, started[1].ended]).toEqual([true, false]);
	await Promise.all(next);
	const later = ask("d");
	expect(urls()).toEqual([["slow"], ["b", "c"], ["d"]]);
	started[2].answer();
	expect((await later).status).toBe(200);
	// The time of one that has been answered runs no more.
	vi.advanceTimersByTime(10_000);
	expect(started[2].ended).toBe(false);
});

it("tells who asked a thread that broke", async () => {
	const answer = ask("a");
	started[0].emit("error", new Error("out of memory"));
	await expect(answer).rejects.toMatchObject({ status: 503, message: "the thread that grew it broke" });
});
