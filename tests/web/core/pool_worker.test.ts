import { expect, it, vi } from "vitest";
import { PoolWorker } from "../../../web/src/core/pool_worker";
import { messageOf } from "../../../web/src/locale/message_error";
import { FakeWorker, module, withSeed } from "./fake_worker";

function seated() {
	const worker = new FakeWorker();
	const events = { answered: vi.fn(), died: vi.fn() };
	return { worker, events, seat: new PoolWorker(() => worker as unknown as Worker, events) };
}

const compiled = { wasm: "bunch.wasm", module: Promise.resolve(module) };

it("nothing is heard of a worker after its end, nor anything said to it", async () => {
	const { worker, events, seat } = seated();
	seat.warm(compiled);
	seat.grow(1, withSeed(1).blocks, compiled);
	seat.end();
	await Promise.resolve();
	expect(worker.terminated).toBe(true);
	expect(worker.heard).toEqual([]);
	worker.send({
		type: "failed",
		id: 1,
		reason: "limit",
		message: messageOf("late"),
		line: 0,
		column: 0,
		memoryBytes: 0,
	});
	worker.send({ type: "broken", message: messageOf("late") });
	worker.crash("late");
	expect(events.answered).not.toHaveBeenCalled();
	expect(events.died).not.toHaveBeenCalled();
});

it("a worker dies but once, and it is told whether it ever lived", async () => {
	const { worker, events } = seated();
	worker.crash("no script");
	worker.crash("still none");
	expect(events.died.mock.calls).toEqual([["no script", false]]);
	expect(worker.terminated).toBe(true);
	const other = seated();
	other.seat.warm(compiled);
	await vi.waitFor(() => expect(other.worker.heard).toHaveLength(1));
	other.worker.onmessageerror?.();
	expect(other.events.died.mock.calls).toEqual([["its answer could not be read", true]]);
});

it("ends a worker that a request cannot be sent to, so that its request is refused and waits no longer", async () => {
	const { worker, events, seat } = seated();
	vi.spyOn(worker, "postMessage").mockImplementation((message) => {
		if (message.type === "grow") structuredClone({ message, uncloneable: () => {} });
	});
	seat.grow(1, withSeed(1).blocks, compiled);
	await vi.waitFor(() => expect(events.died).toHaveBeenCalledOnce());
	expect(events.died.mock.calls[0][0]).toMatch(/^the request could not be sent: /);
	expect(worker.terminated).toBe(true);
});
