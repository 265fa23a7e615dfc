import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeWorker, module, seedOf, settled, sharedPool, withSeed } from "./fake_worker";

beforeEach(() => {
	vi.useFakeTimers();
	FakeWorker.all = [];
	vi.stubGlobal("Worker", FakeWorker);
	vi.stubGlobal("location", new URL(import.meta.url));
	vi.stubGlobal("navigator", { hardwareConcurrency: 2 });
	vi.stubGlobal("fetch", async () => new Response("", { headers: { "content-type": "application/wasm" } }));
	vi.spyOn(WebAssembly, "compileStreaming").mockResolvedValue(module);
	vi.resetModules();
});
afterEach(() => {
	vi.clearAllTimers();
	vi.useRealTimers();
	vi.unstubAllGlobals();
	vi.restoreAllMocks();
});

/** The library, the app's clients and two elements, as one copy of the script starts them. */
async function openPage() {
	const { Client } = await import("../../../web/src/core/client");
	const { PageRuntime } = await import("../../../web/src/library/page_runtime");
	const library = new PageRuntime();
	const clients = [new Client({ concurrency: 2 }), new Client({ background: true }), ...[1, 2].map(() => new Client())];
	return (seed: number) => [
		library.grow("bunch.wasm", withSeed(seed).blocks),
		...clients.map((client, index) => client.grow(withSeed(seed + index + 1))),
	];
}

/** Finishes growths until none is left. */
async function finishAll(): Promise<void> {
	for (let turn = 0; turn < 20; turn++) {
		await settled();
		for (const worker of FakeWorker.all) if (worker.seeds.length > worker.finished) worker.finish();
	}
}

it("starts two workers for the app or library and all elements, on a machine with two processors", async () => {
	const growAll = await openPage();
	const growing = Promise.all(growAll(1));
	await finishAll();
	expect((await growing).map(seedOf)).toEqual([1, 2, 3, 4, 5]);
	// With the spare.
	expect(FakeWorker.all.length).toBeLessThanOrEqual(3);
	expect(FakeWorker.all.filter(({ seeds }) => seeds.length > 0)).toHaveLength(2);
});

it("starts other workers for another copy of the script on the same page", async () => {
	const first = await openPage();
	const growing = first(1);
	await settled();
	vi.resetModules();
	const second = await openPage();
	growing.push(...second(11));
	await finishAll();
	expect((await Promise.all(growing)).map(seedOf)).toEqual([1, 2, 3, 4, 5, 11, 12, 13, 14, 15]);
	const working = FakeWorker.all.map(({ seeds }) => seeds).filter(({ length }) => length > 0);
	expect(working.map((seeds) => new Set(seeds.map((seed) => seed > 10)).size)).toEqual([1, 1, 1, 1]);
});

it("ends the workers some time after the last user has left, and starts others for the next", async () => {
	const pool = sharedPool();
	const [one, other] = [pool.enter(), pool.enter()];
	expect(other.pool).toBe(one.pool);
	const grown = one.pool.run(withSeed(1));
	await settled();
	FakeWorker.all[0].finish();
	await grown;
	one.leave();
	await vi.advanceTimersByTimeAsync(60_000);
	const alive = () => FakeWorker.all.filter(({ terminated }) => !terminated).length;
	expect(alive()).toBe(2);
	other.leave();
	await vi.advanceTimersByTimeAsync(9000);
	expect(pool.enter().pool).toBe(one.pool);
	await vi.advanceTimersByTimeAsync(60_000);
	expect(alive()).toBe(2);
});
