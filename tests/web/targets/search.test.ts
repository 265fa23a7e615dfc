import { describe, expect, it } from "vitest";
import { Search, type Unknown } from "../../../web/src/targets/search";

/** Evaluates the points that the search proposes until it stops or has proposed `most`; returns the smallest distance from the goal. */
function searched(
	unknowns: readonly Unknown[],
	from: readonly number[],
	at: (place: readonly number[]) => number[],
	most = 15,
): { search: Search; looks: number; miss: number } {
	const search = new Search(unknowns, from, at(from));
	let looks = 1;
	for (; looks < most && Math.hypot(...search.best.residuals) > 1e-3; looks++) {
		const next = search.next();
		if (!next) break;
		expect(next.every((value, i) => value >= unknowns[i].from && value <= unknowns[i].to)).toBe(true);
		search.record(next, at(next));
	}
	return { search, looks, miss: Math.hypot(...search.best.residuals) };
}

const unknown = { from: -5, to: 5, slope: 1 };

describe("a search", () => {
	it("finds where a line crosses in two looks, its slope known", () => {
		const { looks, miss } = searched([{ ...unknown, slope: 3 }], [0], ([x]) => [3 * x - 2]);
		expect(miss).toBeLessThan(1e-3);
		expect(looks).toBe(2);
	});

	it.each([0.4, 1, 2.5, -1])("finds its way along a curve whose slope is %s of what was said", (share) => {
		const { looks, miss } = searched([{ ...unknown, slope: Math.sign(share) }], [0], ([x]) => [
			share * (x + 0.1 * x * x) - 1,
		]);
		expect(miss).toBeLessThan(1e-3);
		expect(looks).toBeLessThan(10);
	});

	it("comes near on steps and through noise", () => {
		const rough = (x: number) => Math.floor(40 * x) / 40 + 0.01 * Math.sin(997 * x);
		const { miss } = searched([{ ...unknown, slope: 0.6 }], [0], ([x]) => [rough(x) - 0.8]);
		expect(miss).toBeLessThan(0.03);
	});

	it("finds two unknowns that move each other's residuals", () => {
		const { looks, miss } = searched([unknown, unknown], [0, 0], ([x, y]) => [
			x + 0.4 * y - 1,
			y - 0.3 * x + 0.05 * x * x + 0.5,
		]);
		expect(miss).toBeLessThan(1e-3);
		expect(looks).toBeLessThan(10);
	});

	it("rests at the bound beyond which the goal lies, and says which unknown that is", () => {
		const { search, looks } = searched([unknown, { ...unknown, to: 1 }], [0, 0], ([x, y]) => [x - 2, y - 3]);
		expect(search.best.at[0]).toBeCloseTo(2);
		expect(search.best.at[1]).toBe(1);
		expect(search.atLimit).toEqual([1]);
		expect(looks).toBeLessThan(10);
	});

	it("rests where nothing comes of anything", () => {
		const { looks } = searched([unknown], [0], () => [1]);
		expect(looks).toBeLessThan(8);
	});
});
