/**
 * The runtime of the library: the way of growing in browsers or Node. Each entry point (browser.ts, node.ts) sets its
 * own.
 */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";

export interface Runtime {
	/**
	 * @param wasm the file of a model's core: `bunch.wasm`
	 * @param signal cancels, if possible also a running growth
	 */
	grow(wasm: string, blocks: readonly Block[], signal?: AbortSignal): Promise<Answer>;
}

let current: Runtime | undefined;

/** Sets the runtime; the entry points call it once. */
export function setRuntime(runtime: Runtime): void {
	current = runtime;
}

/**
 * Returns the runtime.
 * @throws Error if no entry point has set one
 */
export function runtime(): Runtime {
	if (!current) throw new Error("The library was not entered by its front door; import “panicle”.");
	return current;
}
