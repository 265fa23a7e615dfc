import { expect, it, vi } from "vitest";
import { CoreQueue } from "../../wasm-core/tools/core_queue.mjs";

/** A queue whose builds end when the test resolves them. */
function queueOf(models: string[]) {
	const started: string[] = [];
	const ends: ((isBuilt: boolean) => void)[] = [];
	const build = (model: string) => {
		started.push(model);
		return new Promise<boolean>((resolve) => ends.push(resolve));
	};
	const onState = vi.fn();
	const queue = new CoreQueue(models, build, onState);
	const end = async (isBuilt = true) => {
		ends.shift()?.(isBuilt);
		await new Promise((resolve) => setImmediate(resolve));
	};
	return { queue, started, onState, end };
}

it("builds one module after another, in the order given", async () => {
	const { queue, started, end } = queueOf(["bunch", "flower", "growth"]);
	const whole = queue.run();
	expect(started).toEqual(["bunch"]);
	await end();
	expect(started).toEqual(["bunch", "flower"]);
	await end();
	await end();
	await whole;
	expect(started).toEqual(["bunch", "flower", "growth"]);
});

it("builds a requested module next, and reports it while someone waits", async () => {
	const { queue, started, onState, end } = queueOf(["bunch", "flower", "growth"]);
	queue.run();
	const waiting = queue.wait("growth");
	expect(onState.mock.calls).toEqual([["growth", "building"]]);
	expect(queue.requested).toEqual(["growth"]);
	await end();
	expect(started).toEqual(["bunch", "growth"]);
	await end();
	expect(await waiting).toBe(true);
	expect(onState.mock.calls.slice(1)).toEqual([["growth", "ready"]]);
	expect(queue.requested).toEqual([]);
});

it("answers at once for a module that is built or unknown", async () => {
	const { queue, onState, end } = queueOf(["bunch"]);
	queue.run();
	await end();
	expect(await queue.wait("bunch")).toBe(true);
	expect(await queue.wait("toy")).toBe(true);
	expect(onState).not.toHaveBeenCalled();
});

it("reports a module that does not compile, and goes on with the next", async () => {
	const { queue, started, onState, end } = queueOf(["bunch", "flower"]);
	queue.run();
	const waiting = queue.wait("bunch");
	await end(false);
	expect(await waiting).toBe(false);
	expect(onState).toHaveBeenLastCalledWith("bunch", "failed");
	expect(started).toEqual(["bunch", "flower"]);
});
