import { describe, expect, it } from "vitest";
import { writeContainer } from "../../../web/src/core/container";
import { CoreTrap, Superseded, UnsupportedError } from "../../../web/src/core/errors";
import { messageOf } from "../../../web/src/locale/message_error";
import { client, FakeWorker, module, seedOf, settled, start, useFakeWorkers, withSeed } from "./fake_worker";

useFakeWorkers();

describe("a worker that breaks", () => {
	const trap = (worker: FakeWorker) =>
		worker.send({ type: "trapped", id: worker.requests.at(-1)?.id ?? 0, message: messageOf("The core broke.") });

	it("is replaced, and the request tried once more", async () => {
		start();
		const growing = client.grow(withSeed(1));
		await settled();
		trap(FakeWorker.all[0]);
		await settled();
		expect(FakeWorker.all[0].terminated).toBe(true);
		expect(FakeWorker.all[1].seeds).toEqual([1]);
		FakeWorker.all[1].finish();
		expect(seedOf(await growing)).toBe(1);
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
		expect(seedOf(await next)).toBe(2);
	});

	it("by itself is replaced as well, whether at work or idle", async () => {
		start();
		const growing = client.grow(withSeed(1));
		await settled();
		FakeWorker.all[0].crash("out of memory");
		await settled();
		FakeWorker.all[1].finish();
		expect(seedOf(await growing)).toBe(1);
		FakeWorker.all[1].crash("lost");
		const next = client.grow(withSeed(2));
		await settled();
		FakeWorker.all[2].finish();
		expect(seedOf(await next)).toBe(2);
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
		expect(seedOf(await newer)).toBe(2);
	});

	it("leaves answers of the past unheard", async () => {
		start();
		const growing = client.grow(withSeed(1));
		await settled();
		const [worker] = FakeWorker.all;
		trap(worker);
		await settled();
		worker.finish();
		FakeWorker.all[1].send({ type: "grown", id: -1, container: writeContainer([]), milliseconds: 1, memoryBytes: 0 });
		FakeWorker.all[1].finish();
		expect(seedOf(await growing)).toBe(1);
	});
});

describe("where nothing can be grown", () => {
	it("a worker that cannot be made is named, and tried again with the next request", async () => {
		let allowed = false;
		start({
			spawn: () => {
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
		expect(seedOf(await growing)).toBe(2);
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

	it("a core that cannot be had is named, and tried again with the next request", async () => {
		let attempts = 0;
		start({
			compile: async () => {
				attempts++;
				if (attempts === 1) throw new UnsupportedError("fetch", "Not there.");
				return module;
			},
		});
		const refused = client.grow(withSeed(1));
		const newer = client.grow(withSeed(2));
		await expect(refused).rejects.toThrow("Not there.");
		await settled();
		FakeWorker.all.at(-1)?.finish();
		expect(seedOf(await newer)).toBe(2);
		expect(attempts).toBe(2);
	});
});
