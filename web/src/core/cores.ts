/** Cores on the thread that asks: one a module, kept from plant to plant. */
import type { Block } from "./container";
import type { Answer, Core } from "./core";
import { CoreError } from "./errors";

/** A core that took more than this for a plant is given up for a small one. */
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
			const answer = core.grow(blocks);
			if (core.memoryBytes > MOST_MEMORY) this.#cores.delete(wasm);
			return answer;
		} catch (error) {
			if (!(error instanceof CoreError)) this.#cores.delete(wasm);
			throw error;
		}
	}
}
