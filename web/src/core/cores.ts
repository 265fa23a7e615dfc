/** Cores on the thread that asks: one a module, kept from plant to plant. */
import type { Block } from "./container";
import type { Answer, Core } from "./core";
import { CoreError } from "./errors";

/** A core whose memory has grown beyond this is dropped, and the next request gets a new one, bytes. */
const MOST_MEMORY = 256 * 1024 * 1024;

export class Cores {
	readonly #load: (wasm: string) => Promise<Core>;
	readonly #cores = new Map<string, Promise<Core>>();

	/** @param load brings a model's core to life, by the name of its file: `bunch.wasm`; one that failed is asked for again */
	constructor(load: (wasm: string) => Promise<Core>) {
		this.#load = load;
	}

	/**
	 * Grows a request.
	 * @throws CoreError where it cannot be grown, CoreTrap where the core broke, and what `load` throws
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
				if (core.memoryBytes > MOST_MEMORY) this.#cores.delete(wasm);
			}
		} catch (error) {
			if (!(error instanceof CoreError)) this.#cores.delete(wasm);
			throw error;
		}
	}
}
