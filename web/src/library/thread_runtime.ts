import type { Core } from "../core/core";
import { CoreCache } from "../core/cores";
import { addressOf } from "./address_of";
import type { Runtime } from "./runtime";

/**
 * Grows on the calling thread: a running growth cannot be interrupted.
 * @param load instantiates the core at an address
 */
export function threadRuntime(load: (address: string) => Promise<Core>): Runtime {
	const cores = new CoreCache((wasm) => load(addressOf(wasm)));
	return {
		grow: async (wasm, blocks, signal) => {
			signal?.throwIfAborted();
			return cores.grow(wasm, blocks);
		},
	};
}
