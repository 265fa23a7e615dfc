/**
 * Grows plants off the page's thread, for one document. The latest request wins: at most one request waits besides the
 * running one, so a drag never queues up. Several documents have a client each over one pool.
 */
import type { Answer } from "./core";
import { Superseded } from "./errors";
import { type PoolUse, pagePool, type SharedPool } from "./page_pool";
import type { CoreRequest } from "./pool";

export interface ClientOptions {
	/** The source of workers; the page's pool where absent. */
	pool?: SharedPool;
	/**
	 * The most growths of this document at once; 1 where absent. With two, a step of a drag begins at once while the
	 * step before still grows; their answers may arrive in another order.
	 */
	concurrency?: number;
	/** Whether growths leave one worker free for growths of other clients; false where absent. */
	background?: boolean;
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
	readonly #use: PoolUse;
	/** Ends running growths when the client is closed. */
	readonly #closing = new AbortController();
	readonly #concurrency: number;
	readonly #background: boolean;
	#running = 0;
	#waiting: Waiting | undefined;

	constructor({ pool = pagePool, concurrency = 1, background = false }: ClientOptions = {}) {
		this.#use = pool.enter();
		this.#concurrency = concurrency;
		this.#background = background;
	}

	/** Starts fetching a module and the first worker, so that both are ready for the first plant. */
	warm(wasm: string): void {
		this.#use.pool.warm(wasm);
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
				this.#run(order, signal, () => this.#waiting === undefined)
					.finally(() => {
						this.#running--;
						this.#beginWaiting();
					})
					.then(resolve, reject);
			};
			if (this.#running < this.#concurrency) begin();
			else this.#wait(begin, reject, signal);
		});
	}

	/** Grows one of many plants of a document: none replaces another. Rejects as Pool.run does. */
	growMember(order: CoreRequest, { signal }: CancelOptions = {}): Promise<Answer> {
		return this.#run(order, signal);
	}

	/** Closes the client, once. Running growths reject with Superseded. */
	close(): void {
		this.#takeWaiting()?.reject(new Superseded());
		this.#closing.abort(new Superseded());
		this.#use.leave();
	}

	/**
	 * Runs a request until the caller's signal aborts or the client closes.
	 * @param shouldRetry whether to try again when the worker crashes
	 */
	#run(order: CoreRequest, signal: AbortSignal | undefined, shouldRetry = () => true): Promise<Answer> {
		const ending = signal ? AbortSignal.any([signal, this.#closing.signal]) : this.#closing.signal;
		return this.#use.pool.run(order, { signal: ending, shouldRetry, background: this.#background });
	}

	/**
	 * Makes a request the waiting one; the one that waited before rejects with Superseded.
	 * @param begin starts the request
	 */
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

	/** Begins the waiting request, if there is one. */
	#beginWaiting(): void {
		this.#takeWaiting()?.begin();
	}
}
