import { describe, expect, it } from "vitest";
import { diceOf } from "../random_use/dice.mjs";
import { growing } from "../random_use/held.mjs";

describe("dice of random use", () => {
	it("give an action the same numbers whichever actions came before it, and others to other actions and seeds", () => {
		const draw = (seed: number, number: number) => {
			const dice = diceOf(seed, number);
			return [dice.next(), dice.below(1000), dice.between(-5, 5)];
		};
		expect(draw(7, 12)).toEqual(draw(7, 12));
		expect(draw(7, 12)).not.toEqual(draw(7, 13));
		expect(draw(7, 12)).not.toEqual(draw(8, 12));
	});

	it("draw items as often as their weights say, and never one of weight 0", () => {
		const items = [
			{ name: "often", weight: 9 },
			{ name: "seldom", weight: 1 },
			{ name: "never", weight: 0 },
		];
		const drawn = Array.from({ length: 2000 }, (_, i) => diceOf(3, i).weighted(items).name);
		const share = (name: string) => drawn.filter((each) => each === name).length / drawn.length;
		expect(share("often")).toBeGreaterThan(0.85);
		expect(share("often")).toBeLessThan(0.95);
		expect(share("never")).toBe(0);
	});
});

describe("growth of what a page holds", () => {
	const level = { heap: 30, nodes: 8000, listeners: 700, workers: 2 };
	const series = (count: number, change: (i: number) => object = () => ({})) =>
		Array.from({ length: count }, (_, i) => ({ ...level, ...change(i) }));

	it("is found in each of the numbers", () => {
		expect(growing(series(12))).toEqual([]);
		expect(growing(series(12, (i) => ({ heap: 30 + 3 * i })))).toEqual(["heap"]);
		expect(growing(series(12, (i) => ({ nodes: 8000 + 500 * i })))).toEqual(["nodes"]);
		expect(growing(series(12, (i) => ({ listeners: 700 + 60 * i, workers: 2 + i })))).toEqual(["listeners", "workers"]);
	});

	it("is not what is fetched at first, nor a single sample, nor told from a few samples", () => {
		expect(growing(series(12, (i) => ({ heap: i < 4 ? 10 + 5 * i : 30 })))).toEqual([]);
		expect(growing(series(12, (i) => ({ nodes: i === 11 ? 80_000 : 8000 })))).toEqual([]);
		expect(growing(series(5, (i) => ({ heap: 30 + 30 * i })))).toEqual([]);
	});
});
