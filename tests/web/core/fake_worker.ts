import { afterEach, beforeEach, vi } from "vitest";
import { type Client, type ClientOptions, createClient } from "../../../web/src/core/client";
import type { Grown } from "../../../web/src/models/bunch/grown";
import type { FromWorker, ToWorker } from "../../../web/src/core/messages";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";

/** A worker that does what the test tells it to. */
export class FakeWorker {
	static all: FakeWorker[] = [];
	onmessage: ((event: { data: FromWorker }) => void) | null = null;
	onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null;
	onmessageerror: (() => void) | null = null;
	readonly heard: ToWorker[] = [];
	terminated = false;

	constructor() {
		FakeWorker.all.push(this);
	}

	postMessage(message: ToWorker): void {
		this.heard.push(message);
		if (message.type === "start") this.say({ type: "ready" });
	}

	terminate(): void {
		this.terminated = true;
	}

	say(data: FromWorker): void {
		this.onmessage?.({ data });
	}

	crash(message: string): void {
		this.onerror?.({ message, preventDefault: () => {} });
	}

	/** Requests given to it, by seed. */
	get seeds(): number[] {
		return this.requests.map(({ request }) => new DataView(request.buffer).getUint32(16, true));
	}

	get requests() {
		return this.heard.filter((message) => message.type === "grow");
	}

	finish(): void {
		const { id, request } = this.requests.at(-1) as { id: number; request: Uint8Array };
		this.say({ type: "grown", id, grown: grownWith(new DataView(request.buffer).getUint32(16, true)) });
	}
}

export const grownWith = (seed: number) => ({ fingerprint: String(seed) }) as Grown;
export const withSeed = (seed: number) => ({ ...specimenFromPreset(), seed });
/** Lets everything that is due happen; wants fake timers. */
export const settled = () => vi.advanceTimersByTimeAsync(0);
/** What stands for the compiled core. */
export const module = {} as WebAssembly.Module;

/** A client of fake workers, one at a time. */
export let client: Client;

/** Starts it; whoever uses it calls `useFakeWorkers` first. */
export function start(options: Partial<ClientOptions> = {}): void {
	client = createClient({
		wasmUrl: "panicle.wasm",
		workerFactory: () => new FakeWorker() as unknown as Worker,
		compile: async () => module,
		...options,
	});
}

/** Before each test no worker and no real time, after each no client. */
export function useFakeWorkers(): void {
	beforeEach(() => {
		vi.useFakeTimers();
		FakeWorker.all = [];
	});
	afterEach(() => {
		client.close();
		vi.useRealTimers();
	});
}
