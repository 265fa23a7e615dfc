/** Where the library's plants grow: what browsers and Node do differently. Each front door (browser.ts, node.ts) lays its own. */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";

export interface Ground {
	/**
	 * @param wasm the file of a model's core: `bunch.wasm`
	 * @param signal cancels; where that can be, in the midst of growing
	 */
	grow(wasm: string, blocks: readonly Block[], signal?: AbortSignal): Promise<Answer>;
}

let laid: Ground | undefined;

export function layGround(ground: Ground): void {
	laid = ground;
}

export function ground(): Ground {
	if (!laid) throw new Error("The library was not entered by its front door; import “panicle”.");
	return laid;
}
