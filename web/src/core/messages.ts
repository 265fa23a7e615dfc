/** What the page and the worker say to each other. */
import type { CoreReason } from "./errors";
import type { Grown } from "../models/bunch/grown";

/** To the worker: the compiled core, once; then requests. */
export type ToWorker =
	| { type: "start"; module: WebAssembly.Module }
	| { type: "grow"; id: number; request: Uint8Array };

/** From the worker: one `ready` or `broken`, then one answer to each request. */
export type FromWorker =
	| { type: "ready" }
	/** The core could not be brought to life. */
	| { type: "broken"; message: string }
	| { type: "grown"; id: number; grown: Grown }
	/** The request cannot be grown; the worker goes on. */
	| { type: "failed"; id: number; reason: CoreReason; message: string; line: number; column: number }
	/** The core trapped; the worker is to be replaced. */
	| { type: "trapped"; id: number; message: string };
