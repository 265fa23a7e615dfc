import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import type { Pool } from "../core/pool";
import { addressOf } from "./address_of";
import type { Runtime } from "./runtime";

/** Milliseconds for which idle workers stay ready. */
const LINGER = 10_000;

/** Grows in workers, so that the page stays responsive; the workers end after a while without requests. */
export class PageRuntime implements Runtime {
	readonly #start: () => Pool;
	#pool: Pool | undefined;
	#running = 0;
	#leaving: ReturnType<typeof setTimeout> | undefined;

	/** @param start makes the pool of workers, and again after it has ended */
	constructor(start: () => Pool) {
		this.#start = start;
	}

	async grow(wasm: string, blocks: readonly Block[], signal?: AbortSignal): Promise<Answer> {
		this.#pool ??= this.#start();
		this.#running++;
		clearTimeout(this.#leaving);
		try {
			return await this.#pool.run({ wasm: addressOf(wasm), blocks }, signal ? { signal } : {});
		} finally {
			this.#running--;
			if (this.#running === 0) this.#leaving = setTimeout(() => this.#close(), LINGER);
		}
	}

	#close(): void {
		this.#pool?.close();
		this.#pool = undefined;
	}
}
