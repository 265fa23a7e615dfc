import { describe, expect, it } from "vitest";
import { leafSeason } from "../../../../web/src/models/growth/year";

describe("the year's colours", () => {
	it("go from spring's to summer's and on to autumn's, and never back", () => {
		expect([0, 0.12, 0.4, 0.5, 0.78, 1].map((season) => leafSeason(season, false))).toEqual([0, 0, 0.4, 0.4, 1, 1]);
		let last = 0;
		for (let season = 0; season <= 1; season += 0.01) {
			const now = leafSeason(season, false);
			expect(now).toBeGreaterThanOrEqual(last);
			expect(now - last).toBeLessThan(0.03);
			last = now;
		}
	});

	it("are summer's all the year round of evergreens", () => {
		for (const season of [0, 0.2, 0.7, 1]) expect(leafSeason(season, true)).toBe(0.4);
	});
});
