import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Pool } from "../../../web/src/core/pool";
import { PageRuntime } from "../../../web/src/library/page_runtime";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Pools whose answers the test releases. */
function runtimes() {
	const answers: (() => void)[] = [];
	const pools: { run: ReturnType<typeof vi.fn>; close: ReturnType<typeof vi.fn> }[] = [];
	const runtime = new PageRuntime(() => {
		const pool = { run: vi.fn(() => new Promise<void>((resolve) => answers.push(resolve))), close: vi.fn() };
		pools.push(pool);
		return pool as unknown as Pool;
	});
	return { runtime, pools, answers };
}

it("keeps its workers while plants grow and for a while after the last, then gives them up", async () => {
	const { runtime, pools, answers } = runtimes();
	const [one, other] = [runtime.grow("bunch.wasm", []), runtime.grow("bunch.wasm", [])];
	answers[0]();
	await one;
	await vi.advanceTimersByTimeAsync(60_000);
	expect(pools.map(({ close }) => close.mock.calls.length)).toEqual([0]);
	answers[1]();
	await other;
	await vi.advanceTimersByTimeAsync(9000);
	const third = runtime.grow("particles.wasm", []);
	await vi.advanceTimersByTimeAsync(9000);
	answers[2]();
	await third;
	expect(pools.map(({ close }) => close.mock.calls.length)).toEqual([0]);
	await vi.advanceTimersByTimeAsync(10_000);
	expect(pools.map(({ close }) => close.mock.calls.length)).toEqual([1]);
	void runtime.grow("bunch.wasm", []);
	expect(pools).toHaveLength(2);
});

it("asks for a core where it lies, and hands on who may cancel", () => {
	const { runtime, pools } = runtimes();
	const { signal } = new AbortController();
	void runtime.grow("bunch.wasm", [], signal);
	expect(pools[0].run).toHaveBeenCalledWith({ wasm: expect.stringMatching(/bunch.*\.wasm/), blocks: [] }, { signal });
});

it("knows no core that was not built", async () => {
	const { runtime } = runtimes();
	await expect(runtime.grow("fern.wasm", [])).rejects.toThrow("There is no core fern.wasm.");
});
