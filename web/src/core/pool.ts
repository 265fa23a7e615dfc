/**
 * Workers as a pool of seats. A request takes a seat that is free, or waits for one; a seat that breaks is replaced, and
 * its request tried once more. A warm spare stands by, so that cancelling, which ends a worker, costs nothing.
 */
import type { Block } from "./container";
import { Columns } from "./container";
import type { Answer } from "./core";
import { CoreError, CoreTrap, Superseded, UnsupportedError } from "./errors";
import type { FromWorker } from "./messages";
import { type Compiling, PoolWorker } from "./pool_worker";

/** What is to be grown: by which module, and the blocks of the request. */
export interface Order {
	/** Address of the model's module. */
	readonly wasm: string;
	readonly blocks: readonly Block[];
}

export interface RunOptions {
	/** Cancels: a growth that runs is ended with its worker. The promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Whether a worker's death is worth a second try; where it is not, the promise rejects with Superseded. */
	worthAgain?: () => boolean;
}

export interface PoolOptions {
	/** Starts a worker that runs core/worker.ts. */
	spawn: () => Worker;
	/** Fetches and compiles a module. One that failed is asked for again with the next request. */
	compile: (wasm: string) => Promise<WebAssembly.Module>;
	/** Growths side by side at the most, the spare not counted; 1 where absent. */
	seats?: number;
}

interface Job extends Order {
	readonly id: number;
	attempts: number;
	readonly worthAgain: () => boolean;
	resolve(answer: Answer): void;
	reject(reason: unknown): void;
}

/** How often a request is given to a worker before it is given up. */
const MOST_ATTEMPTS = 2;
/** The spare starts this long after a growth, in milliseconds: not before the first picture. */
const SPARE_DELAY = 400;
/** All seats but one end when nothing has been requested for so long, ms: a core keeps the memory that its largest plant took. */
const REST = 4000;
/** A seat whose cores hold more memory than this ends at rest as well, bytes: an instance of WebAssembly never shrinks. */
const MOST_MEMORY = 256 * 1024 * 1024;

export class Pool {
	readonly #options: Required<PoolOptions>;
	readonly #modules = new Map<string, Promise<WebAssembly.Module>>();
	/** The seats, each with what it is at; the spare is none of them. */
	readonly #seats = new Map<PoolWorker, Job | undefined>();
	/** Memory that the cores of seats held after their last growth, bytes. */
	readonly #memory = new WeakMap<PoolWorker, number>();
	readonly #waiting: Job[] = [];
	#spare: PoolWorker | undefined;
	#spareTimer: ReturnType<typeof setTimeout> | undefined;
	#restTimer: ReturnType<typeof setTimeout> | undefined;
	#lastId = 0;

	constructor(options: PoolOptions) {
		this.#options = { seats: 1, ...options };
	}

	/** Starts a worker and fetches a module now, for requests to come. What fails here is told when one does. */
	warm(wasm: string): void {
		try {
			if (this.#seats.size === 0) this.#newWorker().warm(this.#compiling(wasm));
		} catch {
			// The first request tries again, and says why not.
		}
	}

	/**
	 * Grows. The promise rejects with
	 * - CoreError when the request cannot be grown, with line and column for a grammar;
	 * - CoreTrap when the core broke, twice;
	 * - UnsupportedError when nothing can be grown here; a later call tries again;
	 * - Superseded when the pool was closed, or the worker died and the request is not worth another;
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

	/** Ends all workers. What is under way rejects with Superseded. */
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

	/** A seat without work: one that is there, the spare, a new one; none where there are enough. */
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

	/** One compilation serves all workers. Where it fails, all who wait for that module hear of it. */
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

	/** A worker is gone. Its request is tried once more on another. */
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

	/** A seat is free, or may be made: those who wait come on, oldest first. */
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

	/** Those at work may be asked again soon. */
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
				this.#spare = undefined; // Cancelling will start one, or say why not.
			}
		}, SPARE_DELAY);
	}
}

function noWorker(why: string): UnsupportedError {
	return new UnsupportedError("worker", `The worker that grows could not be started (${why}); reload the page.`);
}
