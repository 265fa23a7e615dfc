import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Pool } from "../../../web/src/core/pool";
import { Commons } from "../../../web/src/element/commons";
import type { Renderer } from "../../../web/src/render/renderer";

const pool = vi.fn(() => ({ close: vi.fn() }) as unknown as Pool);
const renderer = vi.fn(async () => ({ dispose: vi.fn() }) as unknown as Renderer);
const hold = vi.fn();
let commons: Commons;
beforeEach(() => {
	vi.useFakeTimers();
	vi.clearAllMocks();
	commons = new Commons({ pool, renderer, hold });
});
afterEach(() => vi.useRealTimers());

it("creates one pool and one renderer for all plants, on first use", async () => {
	const leave = [commons.enter(), commons.enter()];
	expect([pool.mock.calls.length, renderer.mock.calls.length]).toEqual([0, 0]);
	commons.client();
	commons.client();
	expect(await commons.renderer()).toBe(await commons.renderer());
	expect([pool.mock.calls.length, renderer.mock.calls.length]).toEqual([1, 1]);
	leave[0]();
	vi.advanceTimersByTime(60_000);
	expect(pool.mock.results[0].value.close).not.toHaveBeenCalled();
});

it("releases them some time after the last plant has left, unless another comes", async () => {
	const first = commons.enter();
	commons.client();
	const drawn = await commons.renderer();
	first();
	vi.advanceTimersByTime(500);
	const second = commons.enter();
	vi.advanceTimersByTime(60_000);
	expect(drawn.dispose).not.toHaveBeenCalled();
	second();
	await vi.advanceTimersByTimeAsync(1000);
	expect(drawn.dispose).toHaveBeenCalledOnce();
	expect(pool.mock.results[0].value.close).toHaveBeenCalledOnce();
	commons.enter();
	commons.client();
	expect(pool).toHaveBeenCalledTimes(2);
});

it("tries again after a failure to create the renderer", async () => {
	renderer.mockRejectedValueOnce(new Error("no script"));
	await expect(commons.renderer()).rejects.toThrow("no script");
	expect(await commons.renderer()).toBeDefined();
});

it("retains the element's scripts once, with the first plant", () => {
	expect(hold).not.toHaveBeenCalled();
	commons.enter()();
	commons.enter();
	expect(hold).toHaveBeenCalledOnce();
});
