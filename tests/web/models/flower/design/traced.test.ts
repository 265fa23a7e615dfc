import { describe, expect, it } from "vitest";
import { type PixelImage, TraceError } from "../../../../../web/src/import/tracing/picture";
import { tracedMargin } from "../../../../../web/src/models/flower/design/traced";

/** Draws a dark shape on a light ground, with a half width at each share of the height. */
function drawn(half: (along: number) => number, [width, height] = [160, 220]): PixelImage {
	const data = new Uint8ClampedArray(4 * width * height).fill(255);
	for (let y = 10; y < height - 10; y++)
		for (let x = 0; x < width; x++) {
			const along = (height - 10 - y) / (height - 20);
			if (Math.abs(x - width / 2) <= half(along) * (height - 20))
				data.fill(40, 4 * (y * width + x), 4 * (y * width + x) + 3);
		}
	return { width, height, data };
}

describe("a petal in a picture", () => {
	it("has the half widths that were drawn, and its width against its length", () => {
		const half = (u: number) => 0.3 * Math.sin(Math.PI * u ** 0.8);
		const { margin, wide } = tracedMargin(drawn(half), "petal");
		expect(wide).toBeGreaterThan(0.57);
		expect(wide).toBeLessThan(0.63);
		for (const { along, out } of margin.slice(1, -1)) expect(Math.abs(out - half(along) / 0.3)).toBeLessThan(0.05);
		expect(margin[0].along).toBe(0);
		expect(margin[margin.length - 1]).toMatchObject({ along: 1 });
	});

	it("is refused by its name where none is to be seen", () => {
		expect(() =>
			tracedMargin(
				drawn(() => -1),
				"sepal",
			),
		).toThrow(TraceError);
		expect(() =>
			tracedMargin(
				drawn(() => -1),
				"sepal",
			),
		).toThrow(/Could not find a sepal/);
	});
});
