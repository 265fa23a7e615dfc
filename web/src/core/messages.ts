/** What the page and a worker say to each other. `wasm` names a module: the address it was fetched from. */
import type { Block } from "./container";
import type { CoreReason } from "./errors";

/** To the worker: each compiled module once, then requests for it. */
export type ToWorker =
	| { type: "start"; wasm: string; module: WebAssembly.Module }
	| { type: "grow"; id: number; wasm: string; blocks: readonly Block[] };

/** From the worker: one `ready` or `broken` for each module, then one answer to each request. */
export type FromWorker =
	| { type: "ready" }
	/** The core could not be brought to life. */
	| { type: "broken"; message: string }
	/** A container (core/container.ts), the milliseconds that growing it took, and the memory of all cores of the worker. */
	| { type: "grown"; id: number; container: Uint8Array<ArrayBuffer>; milliseconds: number; memoryBytes: number }
	/** The request cannot be grown; the worker goes on. */
	| {
			type: "failed";
			id: number;
			reason: CoreReason;
			message: string;
			line: number;
			column: number;
			memoryBytes: number;
	  }
	/** The core trapped; the worker is to be replaced. */
	| { type: "trapped"; id: number; message: string };
