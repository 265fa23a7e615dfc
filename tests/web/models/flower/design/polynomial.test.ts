import { describe, expect, it } from "vitest";
import { errorOf, fitted, valueAt } from "../../../../../web/src/models/flower/design/polynomial";
import { fitOf, SHAPES } from "../../../../../web/src/models/flower/design/shapes";

const sampled = (of: (t: number) => number, count = 40) =>
	Array.from({ length: count + 1 }, (_, i) => ({ t: i / count, value: of(i / count) }));

describe("a fit of degree 6", () => {
	it("finds the polynomial that its samples are of", () => {
		const known = [0.2, -3, 17.5, 0, -44, 31.25, 6];
		const samples = sampled((t) => valueAt(known, t));
		const found = fitted(samples);
		known.forEach((value, k) => {
			expect(found[k]).toBeCloseTo(value, 8);
		});
		expect(errorOf(found, samples)).toBeLessThan(1e-10);
	});

	it("leaves no polynomial that is nearer in squares", () => {
		const samples = sampled((t) => Math.abs(t - 0.4));
		const found = fitted(samples);
		const squares = (of: readonly number[]) =>
			samples.reduce((sum, { t, value }) => sum + (valueAt(of, t) - value) ** 2, 0);
		for (let k = 0; k < 7; k++)
			for (const by of [-1e-4, 1e-4])
				expect(squares(found.map((value, j) => (j === k ? value + by : value)))).toBeGreaterThan(squares(found));
	});

	it("returns the largest distance", () => {
		expect(
			errorOf(
				[1],
				[
					{ t: 0, value: 1.5 },
					{ t: 1, value: 0.25 },
				],
			),
		).toBe(0.75);
	});

	it("takes seven different places", () => {
		expect(() => fitted(Array.from({ length: 20 }, () => ({ t: 0.5, value: 1 })))).toThrow(RangeError);
	});
});

describe("the table of shapes", () => {
	it.each(Object.entries(SHAPES))("has %s within three hundredths of its formula, as wide as 1", (_, shape) => {
		const fit = fitOf(shape);
		expect(fit.error).toBeLessThan(0.03);
		const widest = Math.max(...sampled((t) => valueAt(fit.coefficients, t)).map(({ value }) => value));
		expect(Math.abs(widest - 1)).toBeLessThan(0.03);
	});
});
