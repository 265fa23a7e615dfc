/**
 * Growing off the page's thread, for one document. Latest wins: besides what runs at most one request waits, so a drag
 * never queues up. Several documents have a client each over one pool.
 */
import type { Answer } from "./core";
import { Superseded } from "./errors";
import { compileCore } from "./loader";
import { type Order, Pool } from "./pool";
import { spawnWorker } from "./spawn";

export interface ClientOptions {
	/** Where workers come from; without it the client has a pool of one seat to itself. */
	pool?: Pool;
	/** Starts a worker that runs core/worker.ts; for a pool of its own. */
	workerFactory?: () => Worker;
	/** Compiles a module; the default fetches it. For a pool of its own. */
	compile?: (wasm: string) => Promise<WebAssembly.Module>;
	/**
	 * Growths of this document side by side at the most; 1 where absent. With two, a step of a drag that comes while the
	 * step before still grows begins at once; their answers may come in another order.
	 */
	abreast?: number;
	/** How many workers of a pool of its own; `abreast` where absent. */
	seats?: number;
	/** Told what works but could be better, such as a server that names a wrong type. */
	onNote?: (text: string) => void;
}

export interface GrowOptions {
	/** Cancels: a growth that runs is ended with its worker. The promise rejects with the signal's reason. */
	signal?: AbortSignal;
}

interface Waiting {
	begin(): void;
	reject(reason: unknown): void;
	/** Stops listening for cancelling: it waits no longer. */
	ignoreSignal(): void;
}

export class Client {
	readonly #pool: Pool;
	/** Ends what is under way when the client is closed; a pool that others share goes on. */
	readonly #closing = new AbortController();
	readonly #ownsPool: boolean;
	readonly #abreast: number;
	#running = 0;
	#waiting: Waiting | undefined;

	constructor({
		pool,
		workerFactory = spawnWorker,
		compile,
		abreast = 1,
		seats = abreast,
		onNote,
	}: ClientOptions = {}) {
		this.#ownsPool = pool === undefined;
		this.#abreast = abreast;
		this.#pool =
			pool ??
			new Pool({
				spawn: workerFactory,
				compile: compile ?? ((wasm) => compileCore(wasm, onNote)),
				seats,
			});
	}

	/** Starts fetching a module and the first worker now, so that both are warm when the first plant is asked for. */
	warm(wasm: string): void {
		this.#pool.warm(wasm);
	}

	/**
	 * Grows what is ordered. The promise rejects with Superseded when a newer call took its place before it had begun:
	 * ignore it, the newer answer follows; else as Pool.run.
	 */
	grow(order: Order, { signal }: GrowOptions = {}): Promise<Answer> {
		return new Promise((resolve, reject) => {
			signal?.throwIfAborted();
			const begin = () => {
				this.#running++;
				this.#pool
					.run(order, { worthAgain: () => this.#waiting === undefined, signal: this.#ending(signal) })
					.finally(() => {
						this.#running--;
						this.#next();
					})
					.then(resolve, reject);
			};
			if (this.#running < this.#abreast) begin();
			else this.#wait(begin, reject, signal);
		});
	}

	/**
	 * Grows one of many that make up a document: each is waited for, and none takes another's place. Rejects as Pool.run does.
	 */
	among(order: Order, { signal }: GrowOptions = {}): Promise<Answer> {
		return this.#pool.run(order, { signal: this.#ending(signal) });
	}

	/** What is under way rejects with Superseded. Ends the workers of a pool of its own. */
	close(): void {
		this.#takeWaiting()?.reject(new Superseded());
		if (this.#ownsPool) this.#pool.close();
		else this.#closing.abort(new Superseded());
	}

	/** A growth ends with its caller's wish or with the client. */
	#ending(signal: AbortSignal | undefined): AbortSignal {
		return signal ? AbortSignal.any([signal, this.#closing.signal]) : this.#closing.signal;
	}

	/** Takes the place of the request that waits. */
	#wait(begin: () => void, reject: (reason: unknown) => void, signal: AbortSignal | undefined): void {
		this.#takeWaiting()?.reject(new Superseded());
		const abort = () => this.#takeWaiting()?.reject(signal?.reason);
		// A drag has one signal for all its requests: each that waits no longer takes its listener along.
		const ignoreSignal = () => signal?.removeEventListener("abort", abort);
		this.#waiting = { begin, reject, ignoreSignal };
		signal?.addEventListener("abort", abort);
	}

	/** The request that waits, which waits no longer. */
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
