import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Client } from "../../../web/src/core/client";
import { Superseded } from "../../../web/src/core/errors";
import { SharedPool } from "../../../web/src/core/page_pool";
import { Pool, type PoolOptions } from "../../../web/src/core/pool";
import { messageOf } from "../../../web/src/locale/message_error";
import { FakeWorker, module, seedOf, settled, withSeed } from "./fake_worker";

let pool: Pool;

function start(options: Partial<PoolOptions> = {}): void {
	pool = new Pool({ spawn: () => new FakeWorker() as unknown as Worker, compile: async () => module, ...options });
}

beforeEach(() => {
	vi.useFakeTimers();
	FakeWorker.all = [];
});
afterEach(() => {
	pool.close();
	vi.useRealTimers();
});

describe("a pool of seats", () => {
	it("grows side by side on as many seats as there may be; the others wait in turn", async () => {
		start({ workers: 2 });
		const all = [1, 2, 3, 4].map((seed) => pool.run(withSeed(seed)));
		await settled();
		expect(FakeWorker.all.map(({ seeds }) => seeds)).toEqual([[1], [2]]);
		FakeWorker.all[1].finish();
		await settled();
		expect(FakeWorker.all.map(({ seeds }) => seeds)).toEqual([[1], [2, 3]]);
		FakeWorker.all[0].finish();
		await settled();
		FakeWorker.all[0].finish();
		FakeWorker.all[1].finish();
		expect((await Promise.all(all)).map(seedOf)).toEqual([1, 2, 3, 4]);
	});

	it("ends all seats but one after a rest, and makes others when they are asked for", async () => {
		start({ workers: 3 });
		const grow = async (seeds: number[]) => {
			const all = seeds.map((seed) => pool.run(withSeed(seed)));
			await settled();
			for (const worker of FakeWorker.all.filter(({ seeds, terminated }) => seeds.length > 0 && !terminated))
				worker.finish();
			return (await Promise.all(all)).map(seedOf);
		};
		const alive = () => FakeWorker.all.filter(({ terminated }) => !terminated).length;
		await grow([1, 2, 3]);
		await vi.advanceTimersByTimeAsync(3000);
		await grow([4]);
		// With the spare.
		await vi.advanceTimersByTimeAsync(3900);
		expect(alive()).toBe(4);
		await vi.advanceTimersByTimeAsync(200);
		expect(alive()).toBe(2);
		expect(await grow([5, 6, 7])).toEqual([5, 6, 7]);
	});

	it("ends a seat whose cores hold much memory after a rest, even the last one", async () => {
		start({ workers: 2 });
		const large = 300 * 1024 * 1024;
		const grow = async (...sizes: number[]) => {
			const all = sizes.map((size) => pool.run(withSeed(size)));
			await settled();
			for (const worker of FakeWorker.all.filter(({ terminated }) => !terminated))
				if (worker.seeds.length > 0) worker.finish(worker.seeds.at(-1));
			await Promise.all(all);
		};
		await grow(large, 5);
		await vi.advanceTimersByTimeAsync(4100);
		const ended = () => FakeWorker.all.filter(({ terminated }) => terminated).flatMap(({ seeds }) => seeds);
		expect(ended()).toEqual([large]);
		await grow(large);
		await vi.advanceTimersByTimeAsync(4100);
		expect(ended()).toEqual([large, 5, large]);
		// The spare takes its place: of all workers it is the only one.
		expect(FakeWorker.all.filter(({ terminated }) => !terminated).map(({ seeds }) => seeds)).toEqual([[]]);
	});

	it("gives each seat a module once, whatever models take turns on it", async () => {
		const compiled: string[] = [];
		start({
			compile: async (wasm) => {
				compiled.push(wasm);
				return module;
			},
		});
		for (const [seed, wasm] of [
			[1, "bunch.wasm"],
			[2, "leaf.wasm"],
			[3, "bunch.wasm"],
		] as const) {
			const growing = pool.run(withSeed(seed, wasm));
			await settled();
			FakeWorker.all[0].finish();
			expect(seedOf(await growing)).toBe(seed);
		}
		expect(compiled).toEqual(["bunch.wasm", "leaf.wasm"]);
		const [{ heard }] = FakeWorker.all;
		expect(heard.map((each) => `${each.type} ${each.wasm}`)).toEqual([
			"start bunch.wasm",
			"grow bunch.wasm",
			"start leaf.wasm",
			"grow leaf.wasm",
			"grow bunch.wasm",
		]);
	});

	it("grows in the background with all workers but one, and last of all that wait", async () => {
		start({ workers: 3 });
		const all = [1, 2, 3].map((seed) => pool.run(withSeed(seed), { background: true }));
		all.push(...[4, 5].map((seed) => pool.run(withSeed(seed))));
		await settled();
		const seeds = () => FakeWorker.all.map((worker) => worker.seeds);
		expect(seeds()).toEqual([[1], [2], [4]]);
		FakeWorker.all[0].finish();
		await settled();
		expect(seeds()).toEqual([[1, 5], [2], [4]]);
		FakeWorker.all[2].finish();
		await settled();
		expect(seeds()).toEqual([[1, 5], [2], [4, 3]]);
		for (const worker of FakeWorker.all) worker.finish();
		expect((await Promise.all(all)).map(seedOf)).toEqual([1, 2, 3, 4, 5]);
	});

	it("grows in the background with its only worker", async () => {
		start();
		const growing = pool.run(withSeed(1), { background: true });
		await settled();
		FakeWorker.all[0].finish();
		expect(seedOf(await growing)).toBe(1);
	});

	it("lets several clients share it, none of whom takes another's place", async () => {
		start();
		const shared = new SharedPool(() => pool);
		const [one, other] = [new Client({ pool: shared }), new Client({ pool: shared })];
		const all = [one.grow(withSeed(1)), other.grow(withSeed(2))];
		for (let turn = 0; turn < 2; turn++) {
			await settled();
			FakeWorker.all[0].finish();
		}
		expect((await Promise.all(all)).map(seedOf)).toEqual([1, 2]);
	});

	it("goes on when one of its clients is closed", async () => {
		start({ workers: 2 });
		const shared = new SharedPool(() => pool);
		const [one, other] = [new Client({ pool: shared }), new Client({ pool: shared })];
		const ended = expect(one.grow(withSeed(1))).rejects.toBeInstanceOf(Superseded);
		const stored = other.grow(withSeed(2));
		await settled();
		one.close();
		await ended;
		FakeWorker.all[1].finish();
		expect(seedOf(await stored)).toBe(2);
		expect(FakeWorker.all.map(({ terminated }) => terminated)).toEqual([true, false]);
	});

	it("never begins what was cancelled while it waited", async () => {
		start();
		const first = pool.run(withSeed(1));
		const cancelling = new AbortController();
		const cancelled = expect(pool.run(withSeed(2), { signal: cancelling.signal })).rejects.toThrow("No more.");
		const last = pool.run(withSeed(3));
		await settled();
		cancelling.abort(new Error("No more."));
		await cancelled;
		FakeWorker.all[0].finish();
		await settled();
		FakeWorker.all[0].finish();
		expect((await Promise.all([first, last])).map(seedOf)).toEqual([1, 3]);
		expect(FakeWorker.all.map(({ seeds }) => seeds)).toEqual([[1, 3]]);
	});

	it("hears nothing of a worker that it has ended", async () => {
		start();
		const cancelling = new AbortController();
		const cancelled = expect(pool.run(withSeed(1), { signal: cancelling.signal })).rejects.toThrow("No more.");
		await settled();
		const [ended] = FakeWorker.all;
		cancelling.abort(new Error("No more."));
		await cancelled;
		const next = pool.run(withSeed(2));
		await settled();
		ended.finish();
		ended.send({ type: "broken", message: messageOf("late") });
		ended.crash("late");
		await settled();
		expect(FakeWorker.all).toHaveLength(2);
		FakeWorker.all[1].finish();
		expect(seedOf(await next)).toBe(2);
	});

	it("does not hand out a spare that has died", async () => {
		start();
		const first = pool.run(withSeed(1));
		await settled();
		FakeWorker.all[0].finish();
		await first;
		await vi.advanceTimersByTimeAsync(1000);
		FakeWorker.all[1].crash("out of memory");
		FakeWorker.all[0].crash("out of memory");
		const next = pool.run(withSeed(2));
		await settled();
		expect(FakeWorker.all).toHaveLength(3);
		FakeWorker.all[2].finish();
		expect(seedOf(await next)).toBe(2);
	});

	it("keeps the seats of one model when another's module cannot be had", async () => {
		start({
			compile: async (wasm) => {
				if (wasm === "leaf.wasm") throw new Error("Not there.");
				return module;
			},
		});
		await expect(pool.run(withSeed(1, "leaf.wasm"))).rejects.toThrow("Not there.");
		const growing = pool.run(withSeed(2));
		await settled();
		expect(FakeWorker.all).toHaveLength(1);
		FakeWorker.all[0].finish();
		expect(seedOf(await growing)).toBe(2);
	});
});
