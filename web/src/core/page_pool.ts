/**
 * The pool of workers that the app, the library and all elements of a page share. It is a variable of this script, not
 * of the page: another version of the script has a pool of its own, with its own cores and messages.
 */
import { compileCore } from "./loader";
import { Pool } from "./pool";
import { spawnWorker } from "./spawn";

/** Milliseconds from the last user's leaving to the end of the workers. */
const LINGER = 10_000;

/** A pool in use. */
export interface PoolUse {
	readonly pool: Pool;
	/** Ends the use; to be called once. */
	leave(): void;
}

/** A pool that starts with its first user and ends some time after its last. */
export class SharedPool {
	readonly #start: () => Pool;
	#pool: Pool | undefined;
	#users = 0;
	#closing: ReturnType<typeof setTimeout> | undefined;

	/** @param start makes the pool, and again after it has ended */
	constructor(start: () => Pool) {
		this.#start = start;
	}

	/** Registers a user of the pool. */
	enter(): PoolUse {
		this.#pool ??= this.#start();
		this.#users++;
		clearTimeout(this.#closing);
		return {
			pool: this.#pool,
			leave: () => {
				this.#users--;
				if (this.#users === 0) this.#closing = setTimeout(() => this.#close(), LINGER);
			},
		};
	}

	/** Ends the pool's workers. */
	#close(): void {
		this.#pool?.close();
		this.#pool = undefined;
	}
}

/** Returns the most workers of a page: at least two, so that an edit does not wait for a search or a batch. */
export const maxPageWorkers = (): number => Math.max(2, Math.min(navigator.hardwareConcurrency, 4));

/** The page's pool. */
export const pagePool = new SharedPool(
	() =>
		new Pool({
			spawn: spawnWorker,
			compile: (wasm) => compileCore(wasm, (note) => console.info(note)),
			workers: maxPageWorkers(),
		}),
);
