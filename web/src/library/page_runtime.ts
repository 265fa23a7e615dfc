import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import type { Pool } from "../core/pool";
import { addressOf } from "./address_of";
import type { Runtime } from "./runtime";

/** Milliseconds that idle workers are kept for a plant more. */
const LINGER = 10_000;

/** Grows in workers, so that the page stays responsive; they are given up when nothing has been asked of them for a while. */
export class PageRuntime implements Runtime {
	readonly #start: () => Pool;
	#pool: Pool | undefined;
	#running = 0;
	#leaving: ReturnType<typeof setTimeout> | undefined;

	/** @param start makes the pool of workers; again after they were given up */
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
