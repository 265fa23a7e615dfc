/**
 * Grows plants off the page's thread, for one document. The latest request wins: at most one request waits besides the
 * running one, so a drag never queues up. Several documents have a client each over one pool.
 */
import type { Answer } from "./core";
import { Superseded } from "./errors";
import { compileCore } from "./loader";
import { type CoreRequest, Pool } from "./pool";
import { spawnWorker } from "./spawn";

export interface ClientOptions {
	/** The source of workers; without it the client has a pool with one worker of its own. */
	pool?: Pool;
	/** Starts a worker that runs core/worker.ts; for a pool of the client's own. */
	workerFactory?: () => Worker;
	/** Compiles a module; the default fetches it. For a pool of the client's own. */
	compile?: (wasm: string) => Promise<WebAssembly.Module>;
	/**
	 * The most growths of this document at once; 1 where absent. With two, a step of a drag begins at once while the
	 * step before still grows; their answers may arrive in another order.
	 */
	concurrency?: number;
	/** The number of workers in a pool of the client's own; `abreast` where absent. */
	workers?: number;
	/** Receives warnings, such as a server that sends a wrong type. */
	onNote?: (text: string) => void;
}

export interface CancelOptions {
	/** Cancels the growth: a running one ends with its worker. The promise rejects with the signal's reason. */
	signal?: AbortSignal;
}

interface Waiting {
	begin(): void;
	reject(reason: unknown): void;
	/** Removes the listener for cancelling. */
	ignoreSignal(): void;
}

export class Client {
	readonly #pool: Pool;
	/** Ends running growths when the client is closed; a shared pool stays open. */
	readonly #closing = new AbortController();
	readonly #ownsPool: boolean;
	readonly #concurrency: number;
	#running = 0;
	#waiting: Waiting | undefined;

	constructor({
		pool,
		workerFactory = spawnWorker,
		compile,
		concurrency = 1,
		workers = concurrency,
		onNote,
	}: ClientOptions = {}) {
		this.#ownsPool = pool === undefined;
		this.#concurrency = concurrency;
		this.#pool =
			pool ??
			new Pool({
				spawn: workerFactory,
				compile: compile ?? ((wasm) => compileCore(wasm, onNote)),
				workers,
			});
	}

	/** Starts fetching a module and the first worker, so that both are ready for the first plant. */
	warm(wasm: string): void {
		this.#pool.warm(wasm);
	}

	/**
	 * Grows a request. The promise rejects with Superseded when a newer call replaced this one before it began: ignore
	 * that, the newer answer follows. Otherwise it rejects as Pool.run does.
	 */
	grow(order: CoreRequest, { signal }: CancelOptions = {}): Promise<Answer> {
		return new Promise((resolve, reject) => {
			signal?.throwIfAborted();
			const begin = () => {
				this.#running++;
				this.#pool
					.run(order, { shouldRetry: () => this.#waiting === undefined, signal: this.#ending(signal) })
					.finally(() => {
						this.#running--;
						this.#next();
					})
					.then(resolve, reject);
			};
			if (this.#running < this.#concurrency) begin();
			else this.#wait(begin, reject, signal);
		});
	}

	/** Grows one of many plants of a document: none replaces another. Rejects as Pool.run does. */
	growMember(order: CoreRequest, { signal }: CancelOptions = {}): Promise<Answer> {
		return this.#pool.run(order, { signal: this.#ending(signal) });
	}

	/** Closes the client. Running growths reject with Superseded; the workers of its own pool end. */
	close(): void {
		this.#takeWaiting()?.reject(new Superseded());
		if (this.#ownsPool) this.#pool.close();
		else this.#closing.abort(new Superseded());
	}

	/** A signal that aborts with the caller's signal or when the client closes. */
	#ending(signal: AbortSignal | undefined): AbortSignal {
		return signal ? AbortSignal.any([signal, this.#closing.signal]) : this.#closing.signal;
	}

	/** Replaces the waiting request. */
	#wait(begin: () => void, reject: (reason: unknown) => void, signal: AbortSignal | undefined): void {
		this.#takeWaiting()?.reject(new Superseded());
		const abort = () => this.#takeWaiting()?.reject(signal?.reason);
		// A drag has one signal for all its requests: remove the listener of each request that no longer waits.
		const ignoreSignal = () => signal?.removeEventListener("abort", abort);
		this.#waiting = { begin, reject, ignoreSignal };
		signal?.addEventListener("abort", abort);
	}

	/** Removes and returns the waiting request. */
	#takeWaiting(): Waiting | undefined {
		const waiting = this.#waiting;
		this.#waiting = undefined;
		waiting?.ignoreSignal();
		return waiting;
	}

	#next(): void {
		this.#takeWaiting()?.begin();
	}
}
