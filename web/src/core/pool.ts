/**
 * A pool of workers. A request takes a free worker, or waits for one; a worker that crashes is replaced, and its
 * request tried once more. A warm spare worker is ready, so that cancelling, which ends a worker, costs nothing.
 */
import type { Block } from "./container";
import { Columns } from "./container";
import type { Answer } from "./core";
import { CoreError, CoreTrap, Superseded, UnsupportedError } from "./errors";
import type { FromWorker } from "./messages";
import { type Compiling, PoolWorker } from "./pool_worker";

/** A request to a core. */
export interface Order {
	/** Address of the model's core. */
	readonly wasm: string;
	readonly blocks: readonly Block[];
}

export interface RunOptions {
	/** Cancels the growth: a running one ends with its worker. The promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Whether to retry when the worker crashes; if not, the promise rejects with Superseded. */
	worthAgain?: () => boolean;
}

export interface PoolOptions {
	/** Starts a worker that runs core/worker.ts. */
	spawn: () => Worker;
	/** Fetches and compiles a module. The next request repeats a failed fetch. */
	compile: (wasm: string) => Promise<WebAssembly.Module>;
	/** The most growths at once, without the spare; 1 where absent. */
	seats?: number;
}

interface Job extends Order {
	readonly id: number;
	attempts: number;
	readonly worthAgain: () => boolean;
	resolve(answer: Answer): void;
	reject(reason: unknown): void;
}

/** How often a request is tried before it fails. */
const MOST_ATTEMPTS = 2;
/** Milliseconds from a growth to the start of the spare: not before the first picture. */
const SPARE_DELAY = 400;
/**
 * Milliseconds without a request after which all workers but one end: a core never gives back the memory of its largest
 * plant.
 */
const REST = 4000;
/** Bytes of memory above which an idle worker ends, too: an instance of WebAssembly never shrinks. */
const MOST_MEMORY = 256 * 1024 * 1024;

export class Pool {
	readonly #options: Required<PoolOptions>;
	readonly #modules = new Map<string, Promise<WebAssembly.Module>>();
	/** The workers with their jobs, without the spare. */
	readonly #seats = new Map<PoolWorker, Job | undefined>();
	/** Bytes of memory of each worker's cores after the last growth. */
	readonly #memory = new WeakMap<PoolWorker, number>();
	readonly #waiting: Job[] = [];
	#spare: PoolWorker | undefined;
	#spareTimer: ReturnType<typeof setTimeout> | undefined;
	#restTimer: ReturnType<typeof setTimeout> | undefined;
	#lastId = 0;

	constructor(options: PoolOptions) {
		this.#options = { seats: 1, ...options };
	}

	/** Starts a worker and fetches a module for requests to come. The first request reports errors. */
	warm(wasm: string): void {
		try {
			if (this.#seats.size === 0) this.#newWorker().warm(this.#compiling(wasm));
		} catch {
			// The first request tries again and reports the reason.
		}
	}

	/**
	 * Grows a request. The promise rejects with
	 * - CoreError when the request cannot be grown, with line and column for a grammar;
	 * - CoreTrap when the core crashed twice;
	 * - UnsupportedError when nothing can be grown here; a later call tries again;
	 * - Superseded when the pool was closed, or the worker crashed and `worthAgain` is false;
	 * - the signal's reason when it was cancelled.
	 */
	run(order: Order, { signal, worthAgain = () => true }: RunOptions = {}): Promise<Answer> {
		return new Promise((resolve, reject) => {
			signal?.throwIfAborted();
			const job: Job = { ...order, id: ++this.#lastId, attempts: 0, worthAgain, resolve, reject };
			if (signal) this.#listen(job, signal);
			this.#begin(job);
		});
	}

	/** Ends all workers. Running growths reject with Superseded. */
	close(): void {
		clearTimeout(this.#spareTimer);
		clearTimeout(this.#restTimer);
		this.#spareTimer = undefined;
		const jobs = [...this.#seats.values(), ...this.#waiting.splice(0)];
		for (const seat of this.#seats.keys()) seat.end();
		this.#seats.clear();
		this.#spare?.end();
		this.#spare = undefined;
		for (const job of jobs) job?.reject(new Superseded());
	}

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

	#cancel(job: Job, reason: unknown): void {
		const at = this.#waiting.indexOf(job);
		if (at >= 0) this.#waiting.splice(at, 1);
		const seat = this.#seatOf(job);
		if (seat) this.#leave(seat);
		job.reject(reason);
		if (seat) this.#next();
	}

	#begin(job: Job): void {
		try {
			const seat = this.#freeWorker();
			if (!seat) {
				this.#waiting.push(job);
				return;
			}
			this.#seats.set(seat, job);
			job.attempts++;
			seat.grow(job.id, job.blocks, this.#compiling(job.wasm));
		} catch (cause) {
			job.reject(noWorker(cause instanceof Error ? cause.message : String(cause)));
			this.#next();
		}
	}

	/** An idle worker, the spare, or a new worker; undefined where the pool is full. */
	#freeWorker(): PoolWorker | undefined {
		for (const [seat, job] of this.#seats) if (!job) return seat;
		if (this.#seats.size >= this.#options.seats) return undefined;
		const spare = this.#spare;
		this.#spare = undefined;
		if (spare) this.#seats.set(spare, undefined);
		return spare ?? this.#newWorker();
	}

	#newWorker(): PoolWorker {
		const seat = this.#makeWorker();
		this.#seats.set(seat, undefined);
		return seat;
	}

	#makeWorker(): PoolWorker {
		const seat: PoolWorker = new PoolWorker(this.#options.spawn, {
			answered: (message) => this.#answered(seat, message),
			died: (message, started) =>
				this.#lost(seat, started ? new CoreTrap(`The worker ended: ${message}.`) : noWorker(message)),
		});
		return seat;
	}

	#answered(seat: PoolWorker, message: Exclude<FromWorker, { type: "ready" | "broken" }>): void {
		const job = this.#seats.get(seat);
		if (!job || message.id !== job.id) return;
		if (message.type === "trapped") {
			seat.end();
			this.#lost(seat, new CoreTrap(message.message));
			return;
		}
		this.#seats.set(seat, undefined);
		this.#memory.set(seat, message.memoryBytes);
		if (message.type === "failed") {
			job.reject(new CoreError(message.reason, message.message, message.line, message.column));
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
			const running = [...this.#seats].filter(([, job]) => job?.wasm === wasm);
			for (const [seat] of running) this.#seats.set(seat, undefined);
			for (const job of [...running.map(([, each]) => each), ...waiting]) job?.reject(error);
			this.#next();
		});
		return { wasm, module };
	}

	/** Removes a crashed worker and retries its job once on another. */
	#lost(seat: PoolWorker, error: Error): void {
		if (this.#spare === seat) this.#spare = undefined;
		if (!this.#seats.has(seat)) return;
		const job = this.#seats.get(seat);
		this.#seats.delete(seat);
		if (!job) return;
		if (!job.worthAgain()) job.reject(new Superseded());
		else if (job.attempts >= MOST_ATTEMPTS) job.reject(error);
		else {
			this.#begin(job);
			return;
		}
		this.#next();
	}

	#seatOf(job: Job): PoolWorker | undefined {
		for (const [seat, each] of this.#seats) if (each === job) return seat;
		return undefined;
	}

	#leave(seat: PoolWorker): void {
		seat.end();
		this.#seats.delete(seat);
	}

	/** Begins the oldest waiting job; without one, schedules the spare and the release of idle workers. */
	#next(): void {
		const job = this.#waiting.shift();
		if (job) {
			this.#begin(job);
			return;
		}
		this.#scheduleSpare();
		clearTimeout(this.#restTimer);
		this.#restTimer = setTimeout(() => this.#rest(), REST);
	}

	/** Ends idle workers, unless one of them still works. */
	#rest(): void {
		if ([...this.#seats.values()].some((job) => job)) return;
		const seats = [...this.#seats.keys()];
		const small = seats.find((seat) => (this.#memory.get(seat) ?? 0) <= MOST_MEMORY);
		for (const seat of seats) if (seat !== small) this.#leave(seat);
	}

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

function noWorker(why: string): UnsupportedError {
	return new UnsupportedError("worker", `The worker that grows could not be started (${why}); reload the page.`);
}
