import { describe, expect, it, vi } from "vitest";
import { CoreError, Superseded } from "../../../web/src/core/errors";
import { messageOf } from "../../../web/src/locale/message_error";
import { client, FakeWorker, module, seedOf, settled, start, useFakeWorkers, withSeed } from "./fake_worker";

useFakeWorkers();

describe("the client", () => {
	it("starts a worker before anything is asked, and gives it the compiled core first", async () => {
		start();
		const growing = client.grow(withSeed(7));
		await settled();
		const [worker] = FakeWorker.all;
		expect(worker.heard[0]).toEqual({ type: "start", wasm: "bunch.wasm", module });
		expect(worker.seeds).toEqual([7]);
		worker.finish();
		expect(seedOf(await growing)).toBe(7);
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
		expect(seedOf(await first)).toBe(1);
		await settled();
		expect(worker.seeds).toEqual([1, 5]);
		worker.finish();
		const settledAll = await outcomes;
		expect(settledAll.slice(0, 3).every((one) => one.status === "rejected" && one.reason instanceof Superseded)).toBe(
			true,
		);
		expect(settledAll[3].status === "fulfilled" && seedOf(settledAll[3].value)).toBe(5);
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

	it("may grow two side by side: the second at once, the third when one of them is done, the latest again", async () => {
		start({ workers: 2 });
		const drag = [1, 2, 3, 4].map((seed) => client.grow(withSeed(seed)));
		const outcomes = Promise.allSettled(drag);
		await settled();
		const [first, second] = FakeWorker.all;
		expect([first.seeds, second.seeds]).toEqual([[1], [2]]);
		second.finish();
		await settled();
		expect([first.seeds, second.seeds]).toEqual([[1], [2, 4]]);
		first.finish();
		second.finish();
		expect((await outcomes).map(({ status }) => status)).toEqual(["fulfilled", "fulfilled", "rejected", "fulfilled"]);
		expect(FakeWorker.all).toHaveLength(2);
	});

	it("gives the core's reason, with line and column, and goes on with the same worker", async () => {
		start();
		const growing = client.grow(withSeed(1));
		const outcome = expect(growing).rejects.toMatchObject({ reason: "syntax", message: "No.", line: 3, column: 9 });
		await settled();
		const [worker] = FakeWorker.all;
		worker.send({
			type: "failed",
			id: worker.requests[0].id,
			reason: "syntax",
			message: messageOf("No."),
			line: 3,
			column: 9,
			memoryBytes: 0,
		});
		await outcome;
		await expect(growing).rejects.toBeInstanceOf(CoreError);
		const next = client.grow(withSeed(2));
		await settled();
		worker.finish();
		expect(seedOf(await next)).toBe(2);
		expect(worker.terminated).toBe(false);
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
		expect(seedOf(await next)).toBe(3);
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
		expect(seedOf(await first)).toBe(1);
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

	it("leaves one listener on a signal, however many requests of a drag it has cancelled", async () => {
		start();
		const { signal } = new AbortController();
		const heard = new Set<unknown>();
		const add = vi.spyOn(signal, "addEventListener").mockImplementation((_, listener) => void heard.add(listener));
		vi.spyOn(signal, "removeEventListener").mockImplementation((_, listener) => void heard.delete(listener));
		const drag = Array.from({ length: 100 }, (_, seed) => client.grow(withSeed(seed), { signal }).catch(() => {}));
		await settled();
		expect(add).toHaveBeenCalled();
		expect(heard.size).toBe(1);
		FakeWorker.all[0].finish();
		await settled();
		expect(heard.size).toBe(0);
		FakeWorker.all[0].finish();
		await Promise.all(drag);
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
		expect(seedOf(await second)).toBe(2);
	});
});

it("rejects running and waiting growths when it is closed, and ends all workers some time later", async () => {
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
	await vi.advanceTimersByTimeAsync(10_000);
	expect(FakeWorker.all.map((worker) => worker.terminated)).toEqual([true, true]);
});
