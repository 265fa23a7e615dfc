/** Cores on the calling thread: one per module, cached from plant to plant. */
import type { Block } from "./container";
import type { Answer, Core } from "./core";
import { CoreError } from "./errors";

/** Bytes of memory beyond which a core is dropped; the next request gets a new one. */
const MAX_MEMORY = 256 * 1024 * 1024;

export class CoreCache {
	readonly #load: (wasm: string) => Promise<Core>;
	readonly #cores = new Map<string, Promise<Core>>();

	/**
	 * @param load instantiates a model's core by the name of its file (`bunch.wasm`); the next request repeats a failed
	 * load
	 */
	constructor(load: (wasm: string) => Promise<Core>) {
		this.#load = load;
	}

	/**
	 * Grows a request.
	 * @throws CoreError where it cannot be grown, CoreTrap where the core crashed, and errors of `load`
	 */
	async grow(wasm: string, blocks: readonly Block[]): Promise<Answer> {
		const loading = this.#cores.get(wasm) ?? this.#load(wasm);
		this.#cores.set(wasm, loading);
		try {
			const core = await loading;
			try {
				return core.grow(blocks);
			} finally {
				// The memory of an instance never shrinks, whether its plant was grown or refused.
				if (core.memoryBytes > MAX_MEMORY) this.#cores.delete(wasm);
			}
		} catch (error) {
			if (!(error instanceof CoreError)) this.#cores.delete(wasm);
			throw error;
		}
	}
}
