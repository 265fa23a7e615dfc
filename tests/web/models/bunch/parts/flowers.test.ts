import { describe, expect, it } from "vitest";
import { openFlowers } from "../../../../../web/src/models/bunch/parts/flowers";
import { pressedBunch } from "../pressed_bunch";

describe("openFlowers", () => {
	it("has none on closed buds nor on berries", () => {
		expect(openFlowers(pressedBunch({ count: 5, opened: 0, set: 0 }).berries)).toHaveLength(0);
		expect(openFlowers(pressedBunch({ count: 5, opened: 1, set: 1 }).berries)).toHaveLength(0);
	});

	it("lists each open flower and how far its stamens still stand out", () => {
		const open = openFlowers(pressedBunch({ count: 3, opened: 0.5, set: 0.5 }).berries);
		expect([...open]).toEqual([0, 0.25, 1, 0.25, 2, 0.25]);
	});
});
