/** Where the library's plants grow: what browsers and Node do differently. Each front door (browser.ts, node.ts) lays its own. */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";

export interface Runtime {
	/**
	 * @param wasm the file of a model's core: `bunch.wasm`
	 * @param signal cancels; where that can be, in the midst of growing
	 */
	grow(wasm: string, blocks: readonly Block[], signal?: AbortSignal): Promise<Answer>;
}

let laid: Runtime | undefined;

export function setRuntime(runtime: Runtime): void {
	laid = runtime;
}

export function runtime(): Runtime {
	if (!laid) throw new Error("The library was not entered by its front door; import “panicle”.");
	return laid;
}
