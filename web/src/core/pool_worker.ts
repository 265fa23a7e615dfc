/** One worker of a pool and its cores. */
import { translatedMessage } from "../locale/message_error";
import type { Block } from "./container";
import type { FromWorker, ToWorker } from "./messages";
import { text } from "./messages.generated";

export interface PoolWorkerEvents {
	/** Receives an answer to a request. */
	answered(message: Exclude<FromWorker, { type: "ready" | "broken" }>): void;
	/** The worker has crashed. `started` is false where it never ran. */
	died(reason: string, started: boolean): void;
}

/** A module by its name, and its compilation. */
export interface Compiling {
	readonly wasm: string;
	readonly module: Promise<WebAssembly.Module>;
}

export class PoolWorker {
	readonly #worker: Worker;
	readonly #events: PoolWorkerEvents;
	/** Modules that the worker has received. */
	readonly #sent = new Set<string>();
	#started = false;
	#hasEnded = false;

	/** Throws errors of `spawn`. */
	constructor(spawn: () => Worker, events: PoolWorkerEvents) {
		this.#events = events;
		this.#worker = spawn();
		this.#worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#receive(data);
		this.#worker.onerror = (event) => {
			event.preventDefault(); // Handled here; keep it out of the console.
			this.#die(event.message || text("worker_script_failed"));
		};
		this.#worker.onmessageerror = () => this.#die(text("worker_answer_unreadable"));
	}

	/** Instantiates the module's core in the worker once it is compiled. */
	warm({ wasm, module }: Compiling): void {
		this.#whenCompiled(module, (compiled) => this.#sendModule(wasm, compiled));
	}

	/** Sends a request to the worker once the module is compiled. */
	grow(id: number, blocks: readonly Block[], { wasm, module }: Compiling): void {
		this.#whenCompiled(module, (compiled) => {
			this.#sendModule(wasm, compiled);
			if (!this.#hasEnded) this.#post({ type: "grow", id, wasm, blocks });
		});
	}

	/** Ends the worker at once; no more events follow. */
	end(): void {
		this.#hasEnded = true;
		this.#worker.terminate();
	}

	/** Sends a compiled module to the worker, once. */
	#sendModule(wasm: string, module: WebAssembly.Module): void {
		if (this.#sent.has(wasm)) return;
		this.#sent.add(wasm);
		this.#post({ type: "start", wasm, module });
	}

	/**
	 * Calls `then` once the module is compiled. Where it cannot be compiled, the pool learns that from the same
	 * promise.
	 */
	#whenCompiled(module: Promise<WebAssembly.Module>, then: (module: WebAssembly.Module) => void): void {
		module.then(
			(compiled) => {
				if (!this.#hasEnded) then(compiled);
			},
			() => {},
		);
	}

	/**
	 * Sends a message. A request that cannot be copied (DataCloneError, or no memory for the copy) ends the worker: the
	 * pool settles its job as one of a crashed worker.
	 */
	#post(message: ToWorker): void {
		try {
			this.#worker.postMessage(message);
		} catch (error) {
			const reason = error instanceof Error ? error.message : String(error);
			this.#die(text("worker_request_not_sent", { reason }));
		}
	}

	/** Handles a message of the worker. */
	#receive(message: FromWorker): void {
		if (this.#hasEnded) return;
		if (message.type === "broken") this.#die(translatedMessage(message.message).text);
		else if (message.type === "ready") this.#started = true;
		else this.#events.answered(message);
	}

	/** Ends the worker after a failure and reports it, once. */
	#die(reason: string): void {
		if (this.#hasEnded) return;
		this.end();
		this.#events.died(reason, this.#started);
	}
}
