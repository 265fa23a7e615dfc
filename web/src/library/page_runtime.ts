import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import { pagePool, type SharedPool } from "../core/page_pool";
import { addressOf } from "./address_of";
import type { Runtime } from "./runtime";

/** Grows in the page's workers, so that the page stays responsive; the workers end after a while without requests. */
export class PageRuntime implements Runtime {
	readonly #pool: SharedPool;

	constructor(pool: SharedPool = pagePool) {
		this.#pool = pool;
	}

	/** Grows in a worker of the page's pool, which stays as long as something grows. */
	async grow(wasm: string, blocks: readonly Block[], signal?: AbortSignal): Promise<Answer> {
		const request = { wasm: addressOf(wasm), blocks };
		const { pool, leave } = this.#pool.enter();
		try {
			return await pool.run(request, signal ? { signal } : {});
		} finally {
			leave();
		}
	}
}
