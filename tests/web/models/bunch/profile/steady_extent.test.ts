import { describe, expect, it } from "vitest";
import { SteadyExtent } from "../../../../../web/src/models/bunch/profile/steady_extent";

describe("SteadyExtent", () => {
	it("follows at once the first time and after a rest", () => {
		const steady = new SteadyExtent();
		expect(steady.follow(600, "moved", 0)).toBeUndefined();
		expect(steady.extent).toBe(600);
		expect(steady.follow(150, "moved", 1000)).toBeUndefined();
		expect(steady.extent).toBe(150);
	});

	it("is constant while changes follow each other, and catches up when they have stopped", () => {
		const steady = new SteadyExtent();
		steady.follow(600, "moved", 0);
		let later: number | undefined;
		for (let now = 16; now <= 480; now += 16) later = steady.follow(500, "moved", now);
		expect(steady.extent).toBe(600);
		steady.follow(500, "still", 500);
		expect(steady.extent).toBe(600);
		expect(steady.follow(500, "still", 480 + (later as number))).toBeUndefined();
		expect(steady.extent).toBe(500);
	});

	it("is constant while a handle is held, and follows after its release", () => {
		const steady = new SteadyExtent();
		steady.follow(600, "moved", 0);
		expect(steady.follow(500, "held", 1000)).toBeUndefined();
		expect(steady.follow(500, "held", 2000)).toBeUndefined();
		expect(steady.extent).toBe(600);
		expect(steady.follow(500, "still", 2010)).toBe(300);
		steady.follow(500, "still", 2310);
		expect(steady.extent).toBe(500);
	});

	it("follows at once in an element of another size", () => {
		const steady = new SteadyExtent();
		steady.follow(600, "moved", 0);
		steady.forget();
		steady.follow(500, "still", 5);
		expect(steady.extent).toBe(500);
	});

	it("schedules no update if the drag came back", () => {
		const steady = new SteadyExtent();
		steady.follow(600, "moved", 0);
		expect(steady.follow(500, "moved", 16)).toBe(300);
		expect(steady.follow(600, "moved", 32)).toBeUndefined();
	});
});
