import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FrameLoop } from "../../../web/src/render/frame_loop";
import { PixelRatio } from "../../../web/src/render/pixel_ratio";

describe("PixelRatio", () => {
	it("uses the device's ratio, up to the visible limit", () => {
		expect(new PixelRatio(1).rest).toBe(1);
		expect(new PixelRatio(3).rest).toBe(2);
		expect(new PixelRatio(0.5).rest).toBe(1);
	});

	it("gets coarser while frames are slow, within a limit, and does not change the ratio at rest", () => {
		const ratio = new PixelRatio(2);
		for (let i = 0; i < 60; i++) ratio.note(300);
		expect(ratio.moving).toBe(0.5);
		expect(ratio.rest).toBe(2);
	});

	it("gets finer again when frames are fast", () => {
		const ratio = new PixelRatio(1);
		for (let i = 0; i < 30; i++) ratio.note(200);
		const coarse = ratio.moving;
		for (let i = 0; i < 200; i++) ratio.note(8);
		expect(ratio.moving).toBeGreaterThan(coarse);
		expect(ratio.moving).toBe(1);
	});

	it("ignores one slow frame", () => {
		const ratio = new PixelRatio(1);
		ratio.note(16);
		ratio.note(60);
		for (let i = 0; i < 10; i++) ratio.note(16);
		expect(ratio.moving).toBe(1);
	});
});

describe("FrameLoop", () => {
	let now = 0;
	let pending: ((now: number) => void) | undefined;
	const tick = (after = 16) => {
		now += after;
		const run = pending;
		pending = undefined;
		run?.(now);
	};
	beforeEach(() => {
		vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
		pending = undefined;
		now = 0;
		vi.stubGlobal("requestAnimationFrame", (run: (now: number) => void) => {
			pending = run;
			return 1;
		});
		vi.stubGlobal("cancelAnimationFrame", () => {
			pending = undefined;
		});
	});
	afterEach(() => {
		vi.useRealTimers();
		vi.unstubAllGlobals();
	});

	it("draws once for many requests, and not without a request", () => {
		const draw = vi.fn(() => false);
		const loop = new FrameLoop(draw, 1);
		loop.request();
		loop.request();
		tick();
		tick();
		expect(draw).toHaveBeenCalledTimes(1);
		expect(pending).toBeUndefined();
	});

	it("keeps a movement coarse if the same frame is requested otherwise", () => {
		const ratios: number[] = [];
		const loop = new FrameLoop(
			({ ratio }) => {
				ratios.push(ratio);
				return false;
			},
			1,
			true,
		);
		loop.request(true);
		loop.request();
		tick();
		expect(ratios).toEqual([0.5]);
	});

	it("continues while the movement continues", () => {
		let left = 3;
		const draw = vi.fn(() => --left > 0);
		new FrameLoop(draw, 1).request(true);
		for (let i = 0; i < 10; i++) tick();
		expect(draw).toHaveBeenCalledTimes(3);
	});

	it("draws once more in full when a slow movement has ended, and is idle only then", async () => {
		const ratios: number[] = [];
		let left = 12;
		const loop = new FrameLoop(({ ratio }) => {
			ratios.push(ratio);
			return --left > 0;
		}, 1);
		let idle = false;
		loop.request(true);
		void loop.whenIdle().then(() => {
			idle = true;
		});
		for (let i = 0; i < 12; i++) tick(200);
		expect(ratios.at(-1)).toBeLessThan(1);
		await Promise.resolve();
		expect(idle).toBe(false);
		vi.advanceTimersByTime(500);
		tick();
		await Promise.resolve();
		expect(ratios.at(-1)).toBe(1);
		expect(idle).toBe(true);
	});

	it("stops drawing, and resolves all waiting promises", async () => {
		const draw = vi.fn(() => true);
		const loop = new FrameLoop(draw, 1);
		loop.request();
		loop.stop();
		await loop.whenIdle();
		tick();
		loop.request();
		tick();
		expect(draw).not.toHaveBeenCalled();
	});
});
