import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { MAX_WAITING, type SpecimenAnswer, type SpecimenRequest } from "../../../web/src/offline/messages";
import { SpecimenQueue } from "../../../web/src/offline/specimen_queue";

const script = "https://plants.example/app/assets/specimens-1.js";
const requested = (url: string, of = script): SpecimenRequest => ({
	url,
	method: "GET",
	headers: {},
	script: of,
	cores: {},
	release: "1",
});
const answer = (text: string): SpecimenAnswer => ({
	type: "answer",
	status: 200,
	headers: {},
	body: new TextEncoder().encode(text),
});
const textOf = (given: SpecimenAnswer) => (given.type === "answer" ? new TextDecoder().decode(given.body) : given.type);

/** A worker that answers when the test has it do so. */
class Thread {
	onmessage: Worker["onmessage"] = null;
	onerror: Worker["onerror"] = null;
	readonly heard: string[] = [];
	terminate = vi.fn();
	constructor(readonly script: string) {}
	postMessage({ url }: SpecimenRequest): void {
		this.heard.push(url);
	}
	finish(): void {
		this.onmessage?.call(this as never, { data: answer(`${this.heard.at(-1)} grown`) } as MessageEvent);
	}
}

let threads: Thread[];
let queue: SpecimenQueue;
beforeEach(() => {
	vi.useFakeTimers();
	threads = [];
	queue = new SpecimenQueue({
		start: (of) => {
			const thread = new Thread(of);
			threads.push(thread);
			return thread;
		},
	});
});
afterEach(() => vi.useRealTimers());

describe("specimens that a page grows", () => {
	it("are cancelled, whether they run or wait, and the others still grow", async () => {
		const [running, waiting] = [new AbortController(), new AbortController()];
		const answers = [
			queue.request(requested("a"), running.signal),
			queue.request(requested("b"), waiting.signal),
			queue.request(requested("c")),
			queue.request(requested("d"), AbortSignal.abort()),
		];
		waiting.abort();
		running.abort();
		expect(threads.map(({ terminate }) => terminate.mock.calls.length)).toEqual([1, 0]);
		threads[1].finish();
		expect((await Promise.all(answers)).map(textOf)).toEqual(["unable", "unable", "c grown", "unable"]);
	});

	it("come one after the other from one worker, which ends when nothing is requested", async () => {
		const answers = ["a", "b"].map((url) => queue.request(requested(url)));
		expect(threads.map(({ heard }) => heard)).toEqual([["a"]]);
		threads[0].finish();
		threads[0].finish();
		expect((await Promise.all(answers)).map(textOf)).toEqual(["a grown", "b grown"]);
		expect(threads).toHaveLength(1);
		vi.advanceTimersByTime(60_000);
		expect(threads[0].terminate).toHaveBeenCalledOnce();
		void queue.request(requested("c"));
		expect(threads[1].heard).toEqual(["c"]);
	});

	it("are ended with their worker after 30 s, and the next begins in another", async () => {
		const late = queue.request(requested("huge"));
		const next = queue.request(requested("small"));
		vi.advanceTimersByTime(29_999);
		expect(threads[0].terminate).not.toHaveBeenCalled();
		vi.advanceTimersByTime(1);
		expect(threads[0].terminate).toHaveBeenCalledOnce();
		expect(await late).toMatchObject({ status: 503 });
		expect(textOf(await late)).toContain("The plant took more than 30 s");
		expect(threads[1].heard).toEqual(["small"]);
		threads[1].finish();
		expect(textOf(await next)).toBe("small grown");
	});

	it("ignores what a worker that has been ended still sends", async () => {
		const late = queue.request(requested("huge"));
		const next = queue.request(requested("small"));
		vi.advanceTimersByTime(30_000);
		threads[0].finish();
		threads[0].onerror?.call(threads[0] as never, new Event("error") as ErrorEvent);
		expect(await late).toMatchObject({ status: 503 });
		threads[1].finish();
		expect(textOf(await next)).toBe("small grown");
	});

	it("are refused where too many wait", async () => {
		const answers = Array.from({ length: MAX_WAITING + 3 }, (_, i) => queue.request(requested(`${i}`)));
		const refused = await Promise.all(answers.slice(-2));
		expect(refused.map((each) => each.type === "answer" && each.status)).toEqual([503, 503]);
		for (let i = 0; i <= MAX_WAITING; i++) threads[0].finish();
		expect((await Promise.all(answers.slice(0, -2))).map(textOf)).toEqual(
			answers.slice(0, -2).map((_, i) => `${i} grown`),
		);
	});

	it("are left to others where the worker cannot be started, or breaks", async () => {
		const broken = queue.request(requested("a"));
		threads[0].onerror?.call(threads[0] as never, new Event("error") as ErrorEvent);
		expect(await broken).toEqual({ type: "unable" });
		const without = new SpecimenQueue({
			start: () => {
				throw new DOMException("no workers", "SecurityError");
			},
		});
		expect(await without.request(requested("a"))).toEqual({ type: "unable" });
	});

	it("are grown by the script of their own version of the app", async () => {
		const first = queue.request(requested("a"));
		threads[0].finish();
		await first;
		void queue.request(requested("b", `${script}2`));
		expect(threads.map((thread) => [thread.script, thread.heard])).toEqual([
			[script, ["a"]],
			[`${script}2`, ["b"]],
		]);
		expect(threads[0].terminate).toHaveBeenCalledOnce();
	});
});
