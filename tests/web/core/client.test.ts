import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { type Client, createClient } from "../../../web/src/core/client";
import { CoreError, CoreTrap, Superseded, UnsupportedError } from "../../../web/src/core/errors";
import type { Grown } from "../../../web/src/core/grown";
import type { FromWorker, ToWorker } from "../../../web/src/core/messages";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";

/** A worker that does what the test tells it to. */
class FakeWorker {
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

const grownWith = (seed: number) => ({ fingerprint: String(seed) }) as Grown;
const withSeed = (seed: number) => ({ ...specimenFromPreset(), seed });
const settled = () => vi.advanceTimersByTimeAsync(0);
const module = {} as WebAssembly.Module;

let client: Client;
const start = (options: Partial<Parameters<typeof createClient>[0]> = {}) => {
	client = createClient({
		wasmUrl: "panicle.wasm",
		workerFactory: () => new FakeWorker() as unknown as Worker,
		compile: async () => module,
		...options,
	});
	return client;
};

beforeEach(() => {
	vi.useFakeTimers();
	FakeWorker.all = [];
});

afterEach(() => {
	client.close();
	vi.useRealTimers();
});

describe("the client", () => {
	it("starts a worker before anything is asked, and gives it the compiled core first", async () => {
		start();
		const growing = client.grow(withSeed(7));
		await settled();
		const [worker] = FakeWorker.all;
		expect(worker.heard[0]).toEqual({ type: "start", module });
		expect(worker.seeds).toEqual([7]);
		worker.finish();
		expect(await growing).toEqual(grownWith(7));
	});

	it("keeps one request waiting at most, and the latest wins", async () => {
		start();
		const first = client.grow(withSeed(1));
		const dragged = [2, 3, 4, 5].map((seed) => client.grow(withSeed(seed)));
		const outcomes = Promise.allSettled(dragged);
		await settled();
		const [worker] = FakeWorker.all;
		expect(worker.seeds).toEqual([1]);
		worker.finish();
		expect(await first).toEqual(grownWith(1));
		await settled();
		expect(worker.seeds).toEqual([1, 5]);
		worker.finish();
		const settledAll = await outcomes;
		expect(settledAll.slice(0, 3).every((one) => one.status === "rejected" && one.reason instanceof Superseded)).toBe(
			true,
		);
		expect(settledAll[3]).toEqual({ status: "fulfilled", value: grownWith(5) });
	});

	it("never has more than one request under way during a long drag", async () => {
		start();
		const drag = Array.from({ length: 300 }, (_, index) => client.grow(withSeed(index)).catch(() => undefined));
		await settled();
		const [worker] = FakeWorker.all;
		expect(worker.seeds).toEqual([0]);
		worker.finish();
		await settled();
		expect(worker.seeds).toEqual([0, 299]);
		worker.finish();
		await Promise.all(drag);
	});

	it("gives the core's reason, with line and column, and goes on with the same worker", async () => {
		start();
		const growing = client.grow(withSeed(1));
		const outcome = expect(growing).rejects.toMatchObject({ reason: "syntax", message: "No.", line: 3, column: 9 });
		await settled();
		const [worker] = FakeWorker.all;
		worker.say({ type: "failed", id: worker.requests[0].id, reason: "syntax", message: "No.", line: 3, column: 9 });
		await outcome;
		await expect(growing).rejects.toBeInstanceOf(CoreError);
		const next = client.grow(withSeed(2));
		await settled();
		worker.finish();
		expect(await next).toEqual(grownWith(2));
		expect(worker.terminated).toBe(false);
	});
});

describe("a worker that breaks", () => {
	const trap = (worker: FakeWorker) =>
		worker.say({ type: "trapped", id: worker.requests.at(-1)?.id ?? 0, message: "The core broke." });

	it("is replaced, and the request tried once more", async () => {
		start();
		const growing = client.grow(withSeed(1));
		await settled();
		trap(FakeWorker.all[0]);
		await settled();
		expect(FakeWorker.all[0].terminated).toBe(true);
		expect(FakeWorker.all[1].seeds).toEqual([1]);
		FakeWorker.all[1].finish();
		expect(await growing).toEqual(grownWith(1));
	});

	it("twice gives the request up, and the next is grown", async () => {
		start();
		const growing = expect(client.grow(withSeed(1))).rejects.toBeInstanceOf(CoreTrap);
		await settled();
		trap(FakeWorker.all[0]);
		await settled();
		trap(FakeWorker.all[1]);
		await growing;
		const next = client.grow(withSeed(2));
		await settled();
		expect(FakeWorker.all[2].seeds).toEqual([2]);
		FakeWorker.all[2].finish();
		expect(await next).toEqual(grownWith(2));
	});

	it("by itself is replaced as well, whether at work or idle", async () => {
		start();
		const growing = client.grow(withSeed(1));
		await settled();
		FakeWorker.all[0].crash("out of memory");
		await settled();
		FakeWorker.all[1].finish();
		expect(await growing).toEqual(grownWith(1));
		FakeWorker.all[1].crash("lost");
		const next = client.grow(withSeed(2));
		await settled();
		FakeWorker.all[2].finish();
		expect(await next).toEqual(grownWith(2));
	});

	it("makes way for a newer request instead of trying the old one again", async () => {
		start();
		const old = expect(client.grow(withSeed(1))).rejects.toBeInstanceOf(Superseded);
		const newer = client.grow(withSeed(2));
		await settled();
		trap(FakeWorker.all[0]);
		await old;
		await settled();
		expect(FakeWorker.all[1].seeds).toEqual([2]);
		FakeWorker.all[1].finish();
		expect(await newer).toEqual(grownWith(2));
	});

	it("leaves answers of the past unheard", async () => {
		start();
		const growing = client.grow(withSeed(1));
		await settled();
		const [worker] = FakeWorker.all;
		trap(worker);
		await settled();
		worker.finish();
		FakeWorker.all[1].say({ type: "grown", id: -1, grown: grownWith(99) });
		FakeWorker.all[1].finish();
		expect(await growing).toEqual(grownWith(1));
	});
});

describe("cancelling", () => {
	it("ends the worker while the spare stands by", async () => {
		start();
		const first = client.grow(withSeed(1));
		await settled();
		FakeWorker.all[0].finish();
		await first;
		expect(FakeWorker.all).toHaveLength(1);
		await vi.advanceTimersByTimeAsync(1000);
		expect(FakeWorker.all).toHaveLength(2);

		const controller = new AbortController();
		const cancelled = expect(client.grow(withSeed(2), { signal: controller.signal })).rejects.toThrow(/abort/i);
		await settled();
		controller.abort();
		await cancelled;
		expect(FakeWorker.all[0].terminated).toBe(true);

		const next = client.grow(withSeed(3));
		await settled();
		expect(FakeWorker.all[1].seeds).toEqual([3]);
		FakeWorker.all[1].finish();
		expect(await next).toEqual(grownWith(3));
		await vi.advanceTimersByTimeAsync(1000);
		expect(FakeWorker.all).toHaveLength(3);
	});

	it("takes a request that waits out of the line, and leaves the one at work alone", async () => {
		start();
		const first = client.grow(withSeed(1));
		const controller = new AbortController();
		const second = expect(client.grow(withSeed(2), { signal: controller.signal })).rejects.toThrow();
		controller.abort();
		await second;
		await settled();
		FakeWorker.all[0].finish();
		expect(await first).toEqual(grownWith(1));
		expect(FakeWorker.all[0].seeds).toEqual([1]);
		expect(FakeWorker.all[0].terminated).toBe(false);
	});

	it("before asking asks nothing; after the answer does nothing", async () => {
		start();
		await expect(client.grow(withSeed(1), { signal: AbortSignal.abort() })).rejects.toThrow();
		const controller = new AbortController();
		const growing = client.grow(withSeed(2), { signal: controller.signal });
		await settled();
		FakeWorker.all[0].finish();
		await growing;
		controller.abort();
		expect(FakeWorker.all[0].terminated).toBe(false);
		expect(FakeWorker.all[0].seeds).toEqual([2]);
	});

	it("lets the request that waits begin at once", async () => {
		start();
		const controller = new AbortController();
		const first = expect(client.grow(withSeed(1), { signal: controller.signal })).rejects.toThrow();
		const second = client.grow(withSeed(2));
		await settled();
		controller.abort();
		await first;
		await settled();
		expect(FakeWorker.all[1].seeds).toEqual([2]);
		FakeWorker.all[1].finish();
		expect(await second).toEqual(grownWith(2));
	});
});

describe("where nothing can be grown", () => {
	it("a worker that cannot be made is named, and tried again with the next request", async () => {
		let allowed = false;
		start({
			workerFactory: () => {
				if (!allowed) throw new Error("denied by the page's policy");
				return new FakeWorker() as unknown as Worker;
			},
		});
		const refused = client.grow(withSeed(1));
		await expect(refused).rejects.toBeInstanceOf(UnsupportedError);
		await expect(refused).rejects.toThrow(/could not be started \(denied by the page's policy\)/);
		allowed = true;
		const growing = client.grow(withSeed(2));
		await settled();
		FakeWorker.all[0].finish();
		expect(await growing).toEqual(grownWith(2));
	});

	it("a worker whose script cannot be run is tried twice, then named", async () => {
		start({ compile: () => new Promise(() => {}) });
		const growing = expect(client.grow(withSeed(1))).rejects.toMatchObject({
			name: "UnsupportedError",
			missing: "worker",
		});
		FakeWorker.all[0].crash("");
		await settled();
		FakeWorker.all[1].crash("");
		await growing;
		expect(FakeWorker.all).toHaveLength(2);
	});

	it("a core that cannot be had is named to all who ask, and tried again", async () => {
		let attempts = 0;
		start({
			compile: async () => {
				attempts++;
				if (attempts === 1) throw new UnsupportedError("fetch", "Not there.");
				return module;
			},
		});
		const outcomes = await Promise.allSettled([client.grow(withSeed(1)), client.grow(withSeed(2))]);
		expect(outcomes.map((one) => one.status === "rejected" && one.reason.message)).toEqual([
			"Not there.",
			"Not there.",
		]);
		const growing = client.grow(withSeed(3));
		await settled();
		FakeWorker.all.at(-1)?.finish();
		expect(await growing).toEqual(grownWith(3));
		expect(attempts).toBe(2);
	});

	it("a specimen that is none is refused before a worker hears of it", async () => {
		start();
		const broken = { ...specimenFromPreset(), seed: 1.5 };
		await expect(client.grow(broken)).rejects.toBeInstanceOf(CoreError);
		await settled();
		expect(FakeWorker.all[0].requests).toEqual([]);
	});
});

it("closing ends every worker and rejects what is under way", async () => {
	start();
	const first = client.grow(withSeed(1));
	await settled();
	FakeWorker.all[0].finish();
	await first;
	await vi.advanceTimersByTimeAsync(1000);
	const running = expect(client.grow(withSeed(2))).rejects.toBeInstanceOf(Superseded);
	const waiting = expect(client.grow(withSeed(3))).rejects.toBeInstanceOf(Superseded);
	client.close();
	await running;
	await waiting;
	await vi.advanceTimersByTimeAsync(1000);
	expect(FakeWorker.all.map((worker) => worker.terminated)).toEqual([true, true]);
});
