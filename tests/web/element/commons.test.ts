import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Commons } from "../../../web/src/element/commons";
import type { Renderer } from "../../../web/src/render/renderer";

const renderer = vi.fn(async () => ({ dispose: vi.fn() }) as unknown as Renderer);
const hold = vi.fn();
let commons: Commons;
beforeEach(() => {
	vi.useFakeTimers();
	vi.clearAllMocks();
	commons = new Commons({ renderer, hold });
});
afterEach(() => vi.useRealTimers());

it("creates one renderer for all plants, on first use", async () => {
	const leave = [commons.enter(), commons.enter()];
	expect(renderer).not.toHaveBeenCalled();
	const drawn = await commons.renderer();
	expect(await commons.renderer()).toBe(drawn);
	expect(renderer).toHaveBeenCalledOnce();
	leave[0]();
	await vi.advanceTimersByTimeAsync(60_000);
	expect(drawn.dispose).not.toHaveBeenCalled();
});

it("releases it some time after the last plant has left, unless another comes", async () => {
	const first = commons.enter();
	const drawn = await commons.renderer();
	first();
	vi.advanceTimersByTime(500);
	const second = commons.enter();
	vi.advanceTimersByTime(60_000);
	expect(drawn.dispose).not.toHaveBeenCalled();
	second();
	await vi.advanceTimersByTimeAsync(1000);
	expect(drawn.dispose).toHaveBeenCalledOnce();
	commons.enter();
	await commons.renderer();
	expect(renderer).toHaveBeenCalledTimes(2);
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
