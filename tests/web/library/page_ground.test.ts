import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Pool } from "../../../web/src/core/pool";
import { PageGround } from "../../../web/src/library/page_ground";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Pools that answer when they are told to. */
function grounds() {
	const answers: (() => void)[] = [];
	const pools: { run: ReturnType<typeof vi.fn>; close: ReturnType<typeof vi.fn> }[] = [];
	const ground = new PageGround(() => {
		const pool = { run: vi.fn(() => new Promise<void>((resolve) => answers.push(resolve))), close: vi.fn() };
		pools.push(pool);
		return pool as unknown as Pool;
	});
	return { ground, pools, answers };
}

it("keeps its workers while plants grow and for a while after the last, then gives them up", async () => {
	const { ground, pools, answers } = grounds();
	const [one, other] = [ground.grow("bunch.wasm", []), ground.grow("bunch.wasm", [])];
	answers[0]();
	await one;
	await vi.advanceTimersByTimeAsync(60_000);
	expect(pools.map(({ close }) => close.mock.calls.length)).toEqual([0]);
	answers[1]();
	await other;
	await vi.advanceTimersByTimeAsync(9000);
	const third = ground.grow("particles.wasm", []);
	await vi.advanceTimersByTimeAsync(9000);
	answers[2]();
	await third;
	expect(pools.map(({ close }) => close.mock.calls.length)).toEqual([0]);
	await vi.advanceTimersByTimeAsync(10_000);
	expect(pools.map(({ close }) => close.mock.calls.length)).toEqual([1]);
	void ground.grow("bunch.wasm", []);
	expect(pools).toHaveLength(2);
});

it("asks for a core where it lies, and hands on who may cancel", () => {
	const { ground, pools } = grounds();
	const { signal } = new AbortController();
	void ground.grow("bunch.wasm", [], signal);
	expect(pools[0].run).toHaveBeenCalledWith({ wasm: expect.stringMatching(/bunch.*\.wasm/), blocks: [] }, { signal });
});

it("knows no core that was not built", async () => {
	const { ground } = grounds();
	await expect(ground.grow("fern.wasm", [])).rejects.toThrow("There is no core fern.wasm.");
});
