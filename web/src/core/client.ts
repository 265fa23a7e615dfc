/**
 * Growing off the page's thread. Latest wins: while one growth runs at most one more waits, so a drag never queues up.
 * A worker that breaks is replaced; a warm spare stands by, so that cancelling costs nothing.
 */
import type { Specimen } from "../specimen/specimen";
import { CoreError, CoreTrap, Superseded, UnsupportedError } from "./errors";
import type { Grown } from "../models/bunch/grown";
import { compileCore } from "./loader";
import { encodeRequest, type RequestOptions } from "../models/bunch/request";
import { Seat } from "./seat";
import { spawnWorker } from "./spawn";

export interface GrowOptions extends RequestOptions {
	/** Cancels: a growth that runs is ended with its worker. The promise rejects with the signal's reason. */
	signal?: AbortSignal;
}

export interface ClientOptions {
	/** Where panicle.wasm lies. */
	wasmUrl: string | URL;
	/** Starts a worker that runs core/worker.ts. */
	workerFactory?: () => Worker;
	/** Compiles the core; the default fetches `wasmUrl`. */
	compile?: () => Promise<WebAssembly.Module>;
	/** Told what works but could be better, such as a server that names a wrong type. */
	onNote?: (text: string) => void;
}

export interface Client {
	/**
	 * Grows a specimen. The promise rejects with
	 * - Superseded when a newer call took its place before it had begun: ignore it, the newer result follows;
	 * - CoreError when the specimen cannot be grown, with line and column for a grammar;
	 * - CoreTrap when the core broke, twice;
	 * - UnsupportedError when nothing can be grown here; a later call tries again;
	 * - the signal's reason when it was cancelled.
	 */
	grow(specimen: Specimen, options?: GrowOptions): Promise<Grown>;
	/** Ends all workers. What is under way rejects with Superseded. */
	close(): void;
}

/** Starts fetching the core and the first worker at once, so that both are warm when the first bunch is asked for. */
export function createClient(options: ClientOptions): Client {
	return new WorkerClient(options);
}

interface Job {
	id: number;
	request: Uint8Array;
	attempts: number;
	resolve(grown: Grown): void;
	reject(reason: unknown): void;
}

/** How often a request is given to a worker before it is given up. */
const MOST_ATTEMPTS = 2;
/** The spare starts this long after a growth, in milliseconds: not before the first picture. */
const SPARE_DELAY = 400;

class WorkerClient implements Client {
	private readonly spawn: () => Worker;
	private readonly compile: () => Promise<WebAssembly.Module>;
	private module: Promise<WebAssembly.Module> | undefined;
	private seat: Seat | undefined;
	private spare: Seat | undefined;
	private spareTimer: ReturnType<typeof setTimeout> | undefined;
	private running: Job | undefined;
	private waiting: Job | undefined;
	private lastId = 0;

	constructor({ wasmUrl, workerFactory = spawnWorker, compile, onNote }: ClientOptions) {
		this.spawn = workerFactory;
		this.compile = compile ?? (() => compileCore(wasmUrl, onNote));
		this.warmUp();
	}

	grow(specimen: Specimen, { signal, ...options }: GrowOptions = {}): Promise<Grown> {
		return new Promise((resolve, reject) => {
			signal?.throwIfAborted();
			const job: Job = { id: ++this.lastId, request: encodeRequest(specimen, options), attempts: 0, resolve, reject };
			if (signal) this.listen(job, signal);
			if (this.running) {
				this.waiting?.reject(new Superseded());
				this.waiting = job;
			} else {
				this.run(job);
			}
		});
	}

	close(): void {
		clearTimeout(this.spareTimer);
		this.spareTimer = undefined;
		this.waiting?.reject(new Superseded());
		this.running?.reject(new Superseded());
		this.running = this.waiting = undefined;
		this.seat?.end();
		this.spare?.end();
		this.seat = this.spare = undefined;
	}

	/** What fails here fails again, and is told, when something is to be grown. */
	private warmUp(): void {
		try {
			this.seat = this.newSeat();
		} catch {
			this.seat = undefined;
		}
	}

	private listen(job: Job, signal: AbortSignal): void {
		const abort = () => this.cancel(job, signal.reason);
		const { resolve, reject } = job;
		job.resolve = (grown) => {
			signal.removeEventListener("abort", abort);
			resolve(grown);
		};
		job.reject = (reason) => {
			signal.removeEventListener("abort", abort);
			reject(reason);
		};
		signal.addEventListener("abort", abort);
	}

	private cancel(job: Job, reason: unknown): void {
		job.reject(reason);
		if (this.waiting === job) this.waiting = undefined;
		if (this.running !== job) return;
		this.seat?.end();
		this.seat = undefined;
		this.next();
	}

	private run(job: Job): void {
		this.running = job;
		job.attempts++;
		try {
			this.seat ??= this.takeSpare() ?? this.newSeat();
			this.seat.grow(job.id, job.request);
		} catch (cause) {
			job.reject(noWorker(cause instanceof Error ? cause.message : String(cause)));
			this.next();
		}
	}

	/** The running job is settled. */
	private next(): void {
		const job = this.waiting;
		this.running = this.waiting = undefined;
		if (job) this.run(job);
		else this.scheduleSpare();
	}

	private newSeat(): Seat {
		const module = this.compiled();
		const seat: Seat = new Seat(this.spawn, module, {
			answered: (message) => {
				const job = this.running;
				if (!job || message.id !== job.id) return;
				if (message.type === "trapped") {
					seat.end();
					this.lost(seat, new CoreTrap(message.message));
					return;
				}
				if (message.type === "grown") job.resolve(message.grown);
				else job.reject(new CoreError(message.reason, message.message, message.line, message.column));
				this.next();
			},
			died: (message, started) =>
				this.lost(seat, started ? new CoreTrap(`The worker ended: ${message}.`) : noWorker(message)),
		});
		return seat;
	}

	/** One compilation serves all workers. One that failed is tried again with the next request. */
	private compiled(): Promise<WebAssembly.Module> {
		if (this.module) return this.module;
		const module = this.compile();
		this.module = module;
		module.catch((error: unknown) => {
			if (this.module !== module) return;
			this.module = undefined;
			this.seat?.end();
			this.spare?.end();
			this.seat = this.spare = undefined;
			this.running?.reject(error);
			this.waiting?.reject(error);
			this.running = this.waiting = undefined;
		});
		return module;
	}

	/** A worker is gone. The newest request is tried once more on another. */
	private lost(seat: Seat, error: Error): void {
		if (this.spare === seat) this.spare = undefined;
		if (this.seat !== seat) return;
		this.seat = undefined;
		const job = this.running;
		if (!job) return;
		if (this.waiting) {
			job.reject(new Superseded());
			this.next();
		} else if (job.attempts < MOST_ATTEMPTS) {
			this.run(job);
		} else {
			job.reject(error);
			this.next();
		}
	}

	private takeSpare(): Seat | undefined {
		const seat = this.spare;
		this.spare = undefined;
		return seat;
	}

	private scheduleSpare(): void {
		if (this.spare || this.spareTimer !== undefined) return;
		this.spareTimer = setTimeout(() => {
			this.spareTimer = undefined;
			if (this.spare || !this.module) return;
			try {
				this.spare = this.newSeat();
			} catch {
				this.spare = undefined; // Cancelling will start one, or say why not.
			}
		}, SPARE_DELAY);
	}
}

function noWorker(why: string): UnsupportedError {
	return new UnsupportedError(
		"worker",
		`The worker that grows bunches could not be started (${why}); reload the page.`,
	);
}
