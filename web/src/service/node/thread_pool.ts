/**
 * A pool of threads that answer requests, each thread one request at a time. A growth in WebAssembly cannot be
 * interrupted: a request that takes too long, or whose client has left, ends together with its thread, and a new thread
 * replaces it.
 */
import type { Message } from "../../locale/texts";
import { text } from "../messages.generated";
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
			if (this.#closed) throw new Refused(503, text.message("shutting_down"), RETRY);
			if (this.#queue.length >= this.#options.queueLength)
				throw new Refused(503, text.message("too_many_requests"), RETRY);
			const job: Job = { request, resolve, reject, waiting: undefined };
			const { timeout } = this.#options;
			const late = new Refused(503, text.message("no_free_thread", { seconds: timeout / 1000 }), RETRY);
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
		for (const job of [...this.#queue]) this.#dequeue(job, new Refused(503, text.message("shutting_down"), RETRY));
		await Promise.all(this.#slots.map((slot) => this.#endThread(slot, text.message("shutting_down"))));
	}

	/** Starts the next request in a free slot, and its time limit. */
	#next(): void {
		const slot = this.#slots.find(({ job }) => !job);
		const job = slot && this.#queue.shift();
		if (!job) return;
		clearTimeout(job.waiting);
		slot.job = job;
		slot.thread ??= this.#start(slot);
		const { timeout } = this.#options;
		const late = text.message("growth_too_long", { seconds: timeout / 1000 });
		slot.timer = setTimeout(() => void this.#endThread(slot, late), timeout);
		slot.thread.postMessage({ id: ++this.#lastId, ...job.request });
	}

	/**
	 * Starts a thread for a slot. A thread whose memory has grown too large is replaced after its answer; one that fails
	 * ends its request.
	 */
	#start(slot: Slot): Thread {
		const thread = this.#options.start();
		thread.on("message", (response) => {
			if (slot.thread !== thread) return;
			const resolve = ({ resolve }: Job) => resolve(response);
			if (response.heapBytes <= this.#options.mostHeapBytes) this.#endJob(slot, resolve);
			else void this.#replaceThread(slot, resolve);
		});
		const failed = () => {
			if (slot.thread === thread) void this.#endThread(slot, text.message("internal_error"));
		};
		thread.on("error", failed);
		thread.on("exit", failed);
		return thread;
	}

	/**
	 * Ends the job of a client that has left: it leaves the queue, or a growth in progress soon ends with its thread.
	 */
	#abandon(job: Job): void {
		const why = text.message("client_left");
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
	#endThread(slot: Slot, why: Message): Promise<void> {
		return this.#replaceThread(slot, ({ reject }) => reject(new Refused(503, why)));
	}

	/** Ends a slot's thread; the next job starts another. */
	async #replaceThread(slot: Slot, settle: (job: Job) => void): Promise<void> {
		const { thread } = slot;
		slot.thread = undefined;
		this.#endJob(slot, settle);
		await thread?.terminate();
	}

	/**
	 * Ends the job of a slot, which then takes the next one.
	 * @param settle resolves or rejects the job
	 */
	#endJob(slot: Slot, settle: (job: Job) => void): void {
		const { job } = slot;
		clearTimeout(slot.timer);
		slot.job = undefined;
		if (job) settle(job);
		this.#next();
	}
}
