/**
 * A pool of workers. A request takes a free worker, or waits for one; a worker that crashes is replaced, and its
 * request tried once more. A warm spare worker is ready, so that cancelling, which ends a worker, costs nothing.
 */
import { translatedMessage } from "../locale/message_error";
import type { Block } from "./container";
import { Columns } from "./container";
import type { Answer } from "./core";
import { CoreError, CoreTrap, Superseded, UnsupportedError } from "./errors";
import type { FromWorker } from "./messages";
import { text } from "./messages.generated";
import { type Compiling, PoolWorker } from "./pool_worker";

/** A request to a core. */
export interface CoreRequest {
	/** Address of the model's core. */
	readonly wasm: string;
	readonly blocks: readonly Block[];
}

export interface RunOptions {
	/** Cancels the growth: a running one ends with its worker. The promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Whether to retry when the worker crashes; if not, the promise rejects with Superseded. */
	shouldRetry?: () => boolean;
	/** Whether the growth waits for all others, and leaves one worker free for them; false where absent. */
	background?: boolean;
}

export interface PoolOptions {
	/** Starts a worker that runs core/worker.ts. */
	spawn: () => Worker;
	/** Fetches and compiles a module. The next request repeats a failed fetch. */
	compile: (wasm: string) => Promise<WebAssembly.Module>;
	/** The most growths at once, without the spare; 1 where absent. */
	workers?: number;
}

interface Job extends CoreRequest {
	readonly id: number;
	attempts: number;
	readonly shouldRetry: () => boolean;
	readonly background: boolean;
	resolve(answer: Answer): void;
	reject(reason: unknown): void;
}

/** How often a request is tried before it fails. */
const MAX_ATTEMPTS = 2;
/** Milliseconds from a growth to the start of the spare: not before the first picture. */
const SPARE_DELAY = 400;
/**
 * Milliseconds without a request after which all workers but one end: a core never gives back the memory of its largest
 * plant.
 */
const IDLE_DELAY = 4000;
/** Bytes of memory above which an idle worker ends, too: an instance of WebAssembly never shrinks. */
const MAX_MEMORY = 256 * 1024 * 1024;

export class Pool {
	readonly #options: Required<PoolOptions>;
	readonly #modules = new Map<string, Promise<WebAssembly.Module>>();
	/** The workers with their jobs, without the spare. */
	readonly #workers = new Map<PoolWorker, Job | undefined>();
	/** Bytes of memory of each worker's cores after the last growth. */
	readonly #memory = new WeakMap<PoolWorker, number>();
	readonly #waiting: Job[] = [];
	#spare: PoolWorker | undefined;
	#spareTimer: ReturnType<typeof setTimeout> | undefined;
	#restTimer: ReturnType<typeof setTimeout> | undefined;
	#lastId = 0;

	constructor(options: PoolOptions) {
		this.#options = { workers: 1, ...options };
	}

	/** Starts a worker and fetches a module for requests to come. The first request reports errors. */
	warm(wasm: string): void {
		try {
			if (this.#workers.size === 0) this.#newWorker().warm(this.#compiling(wasm));
		} catch {
			// The first request tries again and reports the reason.
		}
	}

	/**
	 * Grows a request. The promise rejects with
	 * - CoreError when the request cannot be grown, with line and column for a grammar;
	 * - CoreTrap when the core crashed twice;
	 * - UnsupportedError when nothing can be grown here; a later call tries again;
	 * - Superseded when the pool was closed, or the worker crashed and `shouldRetry` is false;
	 * - the signal's reason when it was cancelled.
	 */
	run(order: CoreRequest, { signal, shouldRetry = () => true, background = false }: RunOptions = {}): Promise<Answer> {
		return new Promise((resolve, reject) => {
			signal?.throwIfAborted();
			const job: Job = { ...order, id: ++this.#lastId, attempts: 0, shouldRetry, background, resolve, reject };
			if (signal) this.#listen(job, signal);
			this.#begin(job);
		});
	}

	/** Ends all workers. Running growths reject with Superseded. */
	close(): void {
		clearTimeout(this.#spareTimer);
		clearTimeout(this.#restTimer);
		this.#spareTimer = undefined;
		const jobs = [...this.#workers.values(), ...this.#waiting.splice(0)];
		for (const worker of this.#workers.keys()) worker.end();
		this.#workers.clear();
		this.#spare?.end();
		this.#spare = undefined;
		for (const job of jobs) job?.reject(new Superseded());
	}

	/** Cancels the job when the signal aborts, until the job has resolved or rejected. */
	#listen(job: Job, signal: AbortSignal): void {
		const abort = () => this.#cancel(job, signal.reason);
		const { resolve, reject } = job;
		job.resolve = (answer) => {
			signal.removeEventListener("abort", abort);
			resolve(answer);
		};
		job.reject = (reason) => {
			signal.removeEventListener("abort", abort);
			reject(reason);
		};
		signal.addEventListener("abort", abort);
	}

	/** Cancels a job: a running one ends with its worker. It rejects with `reason`. */
	#cancel(job: Job, reason: unknown): void {
		const at = this.#waiting.indexOf(job);
		if (at >= 0) this.#waiting.splice(at, 1);
		const worker = this.#workerOf(job);
		if (worker) this.#terminate(worker);
		job.reject(reason);
		if (worker) this.#next();
	}

	/**
	 * Starts a job on a free worker, or queues it. If no worker can be started, the job rejects and the next one begins.
	 */
	#begin(job: Job): void {
		try {
			const worker = this.#mayBegin(job) ? this.#freeWorker() : undefined;
			if (!worker) {
				this.#waiting.push(job);
				return;
			}
			this.#workers.set(worker, job);
			job.attempts++;
			worker.grow(job.id, job.blocks, this.#compiling(job.wasm));
		} catch (cause) {
			job.reject(noWorker(cause instanceof Error ? cause.message : String(cause)));
			this.#next();
		}
	}

	/** Returns whether a job may take a free worker: one in the background only while another worker stays free. */
	#mayBegin(job: Job): boolean {
		if (!job.background) return true;
		const running = [...this.#workers.values()].filter((each) => each?.background).length;
		return running < Math.max(1, this.#options.workers - 1);
	}

	/** Returns an idle worker, the spare, or a new worker; undefined where the pool is full. */
	#freeWorker(): PoolWorker | undefined {
		for (const [worker, job] of this.#workers) if (!job) return worker;
		if (this.#workers.size >= this.#options.workers) return undefined;
		const spare = this.#spare;
		this.#spare = undefined;
		if (spare) this.#workers.set(spare, undefined);
		return spare ?? this.#newWorker();
	}

	/** Starts a worker for jobs. */
	#newWorker(): PoolWorker {
		const worker = this.#makeWorker();
		this.#workers.set(worker, undefined);
		return worker;
	}

	/** Starts a worker and connects its events to the pool. */
	#makeWorker(): PoolWorker {
		const worker: PoolWorker = new PoolWorker(this.#options.spawn, {
			answered: (message) => this.#answered(worker, message),
			died: (reason, started) =>
				this.#replace(worker, started ? new CoreTrap(text.message("worker_ended", { reason })) : noWorker(reason)),
		});
		return worker;
	}

	/**
	 * Handles a worker's message about its job. A worker that trapped is replaced, and `#replace` decides whether its job
	 * is tried again; otherwise the worker is free for the next job. Messages about cancelled jobs are ignored.
	 */
	#answered(worker: PoolWorker, message: Exclude<FromWorker, { type: "ready" | "broken" }>): void {
		const job = this.#workers.get(worker);
		if (!job || message.id !== job.id) return;
		if (message.type === "trapped") {
			worker.end();
			this.#replace(worker, new CoreTrap(translatedMessage(message.message)));
			return;
		}
		this.#workers.set(worker, undefined);
		this.#memory.set(worker, message.memoryBytes);
		if (message.type === "failed") {
			job.reject(new CoreError(message.reason, translatedMessage(message.message), message.line, message.column));
		} else {
			job.resolve({ columns: new Columns(message.container), milliseconds: message.milliseconds });
		}
		this.#next();
	}

	/** Compiles a module once for all workers. Where that fails, all jobs of the module reject. */
	#compiling(wasm: string): Compiling {
		const known = this.#modules.get(wasm);
		if (known) return { wasm, module: known };
		const module = this.#options.compile(wasm);
		this.#modules.set(wasm, module);
		module.catch((error: unknown) => {
			if (this.#modules.get(wasm) !== module) return;
			this.#modules.delete(wasm);
			const waiting = this.#waiting.filter((job) => job.wasm === wasm);
			for (const job of waiting) this.#waiting.splice(this.#waiting.indexOf(job), 1);
			const running = [...this.#workers].filter(([, job]) => job?.wasm === wasm);
			for (const [worker] of running) this.#workers.set(worker, undefined);
			for (const job of [...running.map(([, each]) => each), ...waiting]) job?.reject(error);
			this.#next();
		});
		return { wasm, module };
	}

	/** Removes a crashed worker and retries its job once on another. */
	#replace(worker: PoolWorker, error: Error): void {
		if (this.#spare === worker) this.#spare = undefined;
		if (!this.#workers.has(worker)) return;
		const job = this.#workers.get(worker);
		this.#workers.delete(worker);
		if (!job) return;
		if (!job.shouldRetry()) job.reject(new Superseded());
		else if (job.attempts >= MAX_ATTEMPTS) job.reject(error);
		else {
			this.#begin(job);
			return;
		}
		this.#next();
	}

	/** Returns the worker that runs a job; undefined where the job waits or is settled. */
	#workerOf(job: Job): PoolWorker | undefined {
		for (const [worker, each] of this.#workers) if (each === job) return worker;
		return undefined;
	}

	/** Ends a worker and removes it from the pool. */
	#terminate(worker: PoolWorker): void {
		worker.end();
		this.#workers.delete(worker);
	}

	/**
	 * Begins the oldest waiting job, those in the background last; without one, schedules the spare and the release of
	 * idle workers.
	 */
	#next(): void {
		const job =
			this.#waiting.find(({ background }) => !background) ?? this.#waiting.find((each) => this.#mayBegin(each));
		if (job) {
			this.#waiting.splice(this.#waiting.indexOf(job), 1);
			this.#begin(job);
			return;
		}
		this.#scheduleSpare();
		clearTimeout(this.#restTimer);
		this.#restTimer = setTimeout(() => this.#releaseIdle(), IDLE_DELAY);
	}

	/** Ends idle workers, unless one of them still works. */
	#releaseIdle(): void {
		if ([...this.#workers.values()].some((job) => job)) return;
		const workers = [...this.#workers.keys()];
		const small = workers.find((worker) => (this.#memory.get(worker) ?? 0) <= MAX_MEMORY);
		for (const worker of workers) if (worker !== small) this.#terminate(worker);
	}

	/**
	 * Starts a spare worker after SPARE_DELAY (ms), with all compiled modules loaded, unless one exists or is scheduled.
	 */
	#scheduleSpare(): void {
		if (this.#spare || this.#spareTimer !== undefined) return;
		this.#spareTimer = setTimeout(() => {
			this.#spareTimer = undefined;
			if (this.#spare || this.#modules.size === 0) return;
			try {
				this.#spare = this.#makeWorker();
				for (const [wasm, module] of this.#modules) this.#spare.warm({ wasm, module });
			} catch {
				this.#spare = undefined; // Cancelling starts a worker, or reports the error.
			}
		}, SPARE_DELAY);
	}
}

/** Returns the error of a worker that could not be started. */
function noWorker(reason: string): UnsupportedError {
	return new UnsupportedError("worker", text.message("worker_not_started", { reason }));
}
