import { afterEach, beforeEach, vi } from "vitest";
import { Client } from "../../../web/src/core/client";
import { type Block, Columns, writeContainer } from "../../../web/src/core/container";
import type { Answer } from "../../../web/src/core/core";
import type { FromWorker, ToWorker } from "../../../web/src/core/messages";
import { SharedPool } from "../../../web/src/core/page_pool";
import { type CoreRequest, Pool, type PoolOptions } from "../../../web/src/core/pool";

/** A worker that a test controls. */
export class FakeWorker {
	static all: FakeWorker[] = [];
	onmessage: ((event: { data: FromWorker }) => void) | null = null;
	onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null;
	onmessageerror: (() => void) | null = null;
	readonly heard: ToWorker[] = [];
	terminated = false;
	/** Number of requests that it has answered by `finish`. */
	finished = 0;

	constructor() {
		FakeWorker.all.push(this);
	}

	postMessage(message: ToWorker): void {
		this.heard.push(message);
		if (message.type === "start") this.send({ type: "ready" });
	}

	terminate(): void {
		this.terminated = true;
	}

	send(data: FromWorker): void {
		this.onmessage?.({ data });
	}

	crash(message: string): void {
		this.onerror?.({ message, preventDefault: () => {} });
	}

	/** Requests given to it, by seed. */
	get seeds(): number[] {
		return this.requests.map(({ blocks }) => seedIn(blocks));
	}

	get requests() {
		return this.heard.filter((message) => message.type === "grow");
	}

	/** @param memoryBytes that its cores hold then */
	finish(memoryBytes = 0): void {
		this.finished++;
		const { id, blocks } = this.requests.at(-1) as { id: number; blocks: readonly Block[] };
		const container = writeContainer([{ name: "seed", data: Uint32Array.of(seedIn(blocks)) }]);
		this.send({ type: "grown", id, container, milliseconds: 1, memoryBytes });
	}
}

const seedIn = (blocks: readonly Block[]) => new Columns(writeContainer(blocks)).uint32("seed")[0];
/** The plant that a request with that seed returns. */
export const seedOf = ({ columns }: Answer) => columns.uint32("seed")[0];
export const withSeed = (seed: number, wasm = "bunch.wasm"): CoreRequest => ({
	wasm,
	blocks: [{ name: "seed", data: Uint32Array.of(seed) }],
});
/** Lets everything that is due happen; wants fake timers. */
export const settled = () => vi.advanceTimersByTimeAsync(0);
/** The stand-in for the compiled core. */
export const module = {} as WebAssembly.Module;

/** A shared pool of fake workers. */
export const sharedPool = (options: Partial<PoolOptions> = {}): SharedPool =>
	new SharedPool(() => new Pool({ spawn: spawnFake, compile: async () => module, ...options }));
const spawnFake = () => new FakeWorker() as unknown as Worker;

/** A client of fake workers. */
export let client: Client;

/** Starts the client and a worker, by default with one growth at a time; tests call `useFakeWorkers` first. */
export function start({ workers = 1, ...options }: Partial<PoolOptions> = {}): void {
	client = new Client({ pool: sharedPool({ workers, ...options }), concurrency: workers });
	client.warm("bunch.wasm");
}

/** Before each test no worker and no real time, after each no worker. */
export function useFakeWorkers(): void {
	beforeEach(() => {
		vi.useFakeTimers();
		FakeWorker.all = [];
	});
	afterEach(() => {
		vi.clearAllTimers();
		vi.useRealTimers();
	});
}
