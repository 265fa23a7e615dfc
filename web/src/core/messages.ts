/** Messages between the page and a worker. `wasm` names a module: the address it was fetched from. */
import type { Message } from "../locale/texts";
import type { Block } from "./container";
import type { CoreReason } from "./errors";

/** To the worker: each compiled module once, then requests for it. */
export type ToWorker =
	| { type: "start"; wasm: string; module: WebAssembly.Module }
	| { type: "grow"; id: number; wasm: string; blocks: readonly Block[] };

/** From the worker: one `ready` or `broken` for each module, then one answer to each request. */
export type FromWorker =
	| { type: "ready" }
	/** The core could not be instantiated. */
	| { type: "broken"; message: Message }
	/** A container (core/container.ts), the milliseconds of growing, and the memory of all cores of the worker. */
	| { type: "grown"; id: number; container: Uint8Array<ArrayBuffer>; milliseconds: number; memoryBytes: number }
	/** The request cannot be grown; the worker goes on. */
	| {
			type: "failed";
			id: number;
			reason: CoreReason;
			message: Message;
			line: number;
			column: number;
			memoryBytes: number;
	  }
	/** The core crashed; replace the worker. */
	| { type: "trapped"; id: number; message: Message };
