/** One worker with its core, from start to end. */
import type { FromWorker, ToWorker } from "./messages";

export interface SeatEvents {
	/** An answer to a request. */
	answered(message: Exclude<FromWorker, { type: "ready" | "broken" }>): void;
	/** The worker is of no further use. `started` tells whether it ever was. */
	died(message: string, started: boolean): void;
}

export class Seat {
	private readonly worker: Worker;
	private readonly module: Promise<WebAssembly.Module>;
	private started = false;
	private over = false;

	/** Throws what `spawn` throws. */
	constructor(
		spawn: () => Worker,
		module: Promise<WebAssembly.Module>,
		private readonly events: SeatEvents,
	) {
		this.worker = spawn();
		this.module = module;
		this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.hear(data);
		this.worker.onerror = (event) => {
			event.preventDefault(); // It is dealt with here; the console need not hear of it.
			this.die(event.message || "its script could not be run");
		};
		this.worker.onmessageerror = () => this.die("its answer could not be read");
		this.send((compiled) => ({ type: "start", module: compiled }));
	}

	grow(id: number, request: Uint8Array): void {
		this.send(() => ({ type: "grow", id, request }));
	}

	/** Ends the worker, whatever it is doing; nothing is heard of it after this. */
	end(): void {
		this.over = true;
		this.worker.terminate();
	}

	/** Messages wait for the core to be compiled. Where it cannot be, the client knows from the same promise. */
	private send(message: (module: WebAssembly.Module) => ToWorker): void {
		this.module.then(
			(module) => {
				if (!this.over) this.worker.postMessage(message(module));
			},
			() => {},
		);
	}

	private hear(message: FromWorker): void {
		if (this.over) return;
		if (message.type === "broken") this.die(message.message);
		else if (message.type === "ready") this.started = true;
		else this.events.answered(message);
	}

	private die(message: string): void {
		if (this.over) return;
		this.end();
		this.events.died(message, this.started);
	}
}
