/**
 * A pool of threads that answer requests, each thread one request at a time. A growth in WebAssembly cannot be
 * interrupted: a request that takes too long, or whose client has left, ends together with its thread, and a new thread
 * replaces it.
 */
import { Refused } from "../refused";
import type { ThreadRequest, ThreadResponse } from "./messages";

/** The part of a `worker_threads` Worker that the pool uses; tests replace it. */
export interface Thread {
	postMessage(request: ThreadRequest): void;
	on(event: "message", listener: (response: ThreadResponse) => void): unknown;
	on(event: "error" | "exit", listener: () => void): unknown;
	terminate(): Promise<unknown>;
}

export interface ThreadPoolOptions {
	start(): Thread;
	readonly threads: number;
	/** The longest time for one answer, and the longest time in the queue, milliseconds. */
	readonly timeout: number;
	/** The most requests in the queue. */
	readonly queueLength: number;
	/** Bytes of memory after a request above which a thread is replaced. */
	readonly mostHeapBytes: number;
}

/**
 * Milliseconds that a growth may continue after its client has left: a short one is cheaper to finish than a thread to
 * start.
 */
const ABANDONED_TIMEOUT = 500;
const CLOSING = "the service is shutting down";
const RETRY = { "retry-after": "5" };

type NewRequest = Omit<ThreadRequest, "id">;

interface Job {
	readonly request: NewRequest;
	readonly resolve: (response: ThreadResponse) => void;
	readonly reject: (error: Error) => void;
	/** Removes a job that waits too long. */
	waiting: ReturnType<typeof setTimeout> | undefined;
}

interface Slot {
	thread: Thread | undefined;
	job: Job | undefined;
	/** Ends the thread of a job that takes too long. */
	timer: ReturnType<typeof setTimeout> | undefined;
}

export class ThreadPool {
	readonly #options: ThreadPoolOptions;
	readonly #slots: Slot[];
	readonly #queue: Job[] = [];
	/** Promises of all unanswered requests. */
	readonly #pending = new Set<Promise<ThreadResponse>>();
	#lastId = 0;
	#closed = false;

	constructor(options: ThreadPoolOptions) {
		this.#options = options;
		this.#slots = Array.from({ length: options.threads }, () => ({
			thread: undefined,
			job: undefined,
			timer: undefined,
		}));
	}

	/**
	 * Answers a request on the next free thread.
	 * @param signal aborted when the client has left: the request leaves the queue, or its growth is ended soon
	 * @throws Refused where the queue is full, the request waits or takes too long, or its thread fails
	 */
	run(request: NewRequest, signal?: AbortSignal): Promise<ThreadResponse> {
		const response = new Promise<ThreadResponse>((resolve, reject) => {
			if (this.#closed) throw new Refused(503, CLOSING, RETRY);
			if (this.#queue.length >= this.#options.queueLength)
				throw new Refused(503, "too many requests; try again in a moment", RETRY);
			const job: Job = { request, resolve, reject, waiting: undefined };
			const { timeout } = this.#options;
			const late = new Refused(503, `no thread was free within ${timeout / 1000} s; try again in a moment`, RETRY);
			job.waiting = setTimeout(() => this.#dequeue(job, late), timeout);
			signal?.addEventListener("abort", () => this.#abandon(job), { once: true });
			this.#queue.push(job);
			this.#next();
		});
		const settled = () => void this.#pending.delete(response);
		this.#pending.add(response);
		response.then(settled, settled);
		return response;
	}

	/** Refuses further requests, answers the pending ones, and ends the threads. */
	async drain(): Promise<void> {
		this.#closed = true;
		await Promise.allSettled(this.#pending);
		await this.close();
	}

	/** Refuses all requests and ends the threads at once. */
	async close(): Promise<void> {
		this.#closed = true;
		for (const job of [...this.#queue]) this.#dequeue(job, new Refused(503, CLOSING, RETRY));
		await Promise.all(this.#slots.map((slot) => this.#endThread(slot, CLOSING)));
	}

	#next(): void {
		const slot = this.#slots.find(({ job }) => !job);
		const job = slot && this.#queue.shift();
		if (!job) return;
		clearTimeout(job.waiting);
		slot.job = job;
		slot.thread ??= this.#start(slot);
		const { timeout } = this.#options;
		const late = `it took more than ${timeout / 1000} s; request a smaller plant or a smaller file`;
		slot.timer = setTimeout(() => void this.#endThread(slot, late), timeout);
		slot.thread.postMessage({ id: ++this.#lastId, ...job.request });
	}

	#start(slot: Slot): Thread {
		const thread = this.#options.start();
		thread.on("message", (response) => {
			if (slot.thread !== thread) return;
			const resolve = ({ resolve }: Job) => resolve(response);
			if (response.heapBytes <= this.#options.mostHeapBytes) this.#endJob(slot, resolve);
			else void this.#replaceThread(slot, resolve);
		});
		const failed = () => {
			if (slot.thread === thread) void this.#endThread(slot, "internal error while generating the plant");
		};
		thread.on("error", failed);
		thread.on("exit", failed);
		return thread;
	}

	#abandon(job: Job): void {
		const why = "the client has left";
		this.#dequeue(job, new Refused(503, why));
		const slot = this.#slots.find((each) => each.job === job);
		if (!slot) return;
		clearTimeout(slot.timer);
		slot.timer = setTimeout(() => void this.#endThread(slot, why), Math.min(ABANDONED_TIMEOUT, this.#options.timeout));
	}

	/** Takes a job out of the queue, if it is still there. */
	#dequeue(job: Job, error: Refused): void {
		const index = this.#queue.indexOf(job);
		if (index < 0) return;
		clearTimeout(job.waiting);
		this.#queue.splice(index, 1);
		job.reject(error);
	}

	/** Ends a slot's thread, and with it the job it works on. */
	#endThread(slot: Slot, why: string): Promise<void> {
		return this.#replaceThread(slot, ({ reject }) => reject(new Refused(503, why)));
	}

	/** Ends a slot's thread; the next job starts another. */
	async #replaceThread(slot: Slot, settle: (job: Job) => void): Promise<void> {
		const { thread } = slot;
		slot.thread = undefined;
		this.#endJob(slot, settle);
		await thread?.terminate();
	}

	#endJob(slot: Slot, settle: (job: Job) => void): void {
		const { job } = slot;
		clearTimeout(slot.timer);
		slot.job = undefined;
		if (job) settle(job);
		this.#next();
	}
}
