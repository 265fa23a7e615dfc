/** One worker with its cores, from start to end. */
import type { Block } from "./container";
import type { FromWorker, ToWorker } from "./messages";

export interface PoolWorkerEvents {
	/** An answer to a request. */
	answered(message: Exclude<FromWorker, { type: "ready" | "broken" }>): void;
	/** The worker is of no further use. `started` tells whether it ever was. */
	died(message: string, started: boolean): void;
}

/** A module on its way: its name and its compilation. */
export interface Compiling {
	readonly wasm: string;
	readonly module: Promise<WebAssembly.Module>;
}

export class PoolWorker {
	readonly #worker: Worker;
	readonly #events: PoolWorkerEvents;
	/** Modules that the worker has been given. */
	readonly #given = new Set<string>();
	#started = false;
	#over = false;

	/** Throws what `spawn` throws. */
	constructor(spawn: () => Worker, events: PoolWorkerEvents) {
		this.#events = events;
		this.#worker = spawn();
		this.#worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data);
		this.#worker.onerror = (event) => {
			event.preventDefault(); // It is dealt with here; the console need not hear of it.
			this.#die(event.message || "its script could not be run");
		};
		this.#worker.onmessageerror = () => this.#die("its answer could not be read");
	}

	/** Has the module's core brought to life as soon as it is compiled. */
	warm({ wasm, module }: Compiling): void {
		this.#when(module, (compiled) => this.#give(wasm, compiled));
	}

	grow(id: number, blocks: readonly Block[], { wasm, module }: Compiling): void {
		this.#when(module, (compiled) => {
			this.#give(wasm, compiled);
			if (!this.#over) this.#post({ type: "grow", id, wasm, blocks });
		});
	}

	/** Ends the worker, whatever it is doing; nothing is heard of it after this. */
	end(): void {
		this.#over = true;
		this.#worker.terminate();
	}

	#give(wasm: string, module: WebAssembly.Module): void {
		if (this.#given.has(wasm)) return;
		this.#given.add(wasm);
		this.#post({ type: "start", wasm, module });
	}

	/** Messages wait for the core to be compiled. Where it cannot be, the pool knows from the same promise. */
	#when(module: Promise<WebAssembly.Module>, then: (module: WebAssembly.Module) => void): void {
		module.then(
			(compiled) => {
				if (!this.#over) then(compiled);
			},
			() => {},
		);
	}

	/** A request that cannot be copied (DataCloneError, or no memory for the copy) ends the worker: its job is settled as that of one that died. */
	#post(message: ToWorker): void {
		try {
			this.#worker.postMessage(message);
		} catch (error) {
			this.#die(`its request could not be sent: ${error instanceof Error ? error.message : error}`);
		}
	}

	#hear(message: FromWorker): void {
		if (this.#over) return;
		if (message.type === "broken") this.#die(message.message);
		else if (message.type === "ready") this.#started = true;
		else this.#events.answered(message);
	}

	#die(message: string): void {
		if (this.#over) return;
		this.end();
		this.#events.died(message, this.#started);
	}
}
