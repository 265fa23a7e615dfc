import { describe, expect, it } from "vitest";
import { TRAITS } from "../../../../../web/src/models/bunch/bunch_plant";
import { metresPerPixel } from "../../../../../web/src/models/bunch/profile/handles";
import { type DrawnBunch, silhouette } from "../../../../../web/src/models/bunch/profile/silhouette";

const PIXEL = metresPerPixel(0.25);
const inPixels = (...values: number[]) => Float32Array.from(values, (value) => value * PIXEL);

/** Traits of berries of these widths and lengths, in pixels. */
function sized(...sizes: [width: number, length: number][]): Float32Array {
	const rest = new Array<number>(TRAITS.length - 2).fill(0);
	return Float32Array.from(sizes.flatMap(([width, length]) => [width * PIXEL, length * PIXEL, ...rest]));
}

/** Berry 0 at the right and in front, berry 1 at the left and behind; one internode between two corners. */
const bunch: DrawnBunch = {
	berries: {
		count: 2,
		spheres: inPixels(30, -100, 40, 12, -50, -200, -60, 15),
		// Hanging straight down; end on to the front view.
		directions: Float32Array.of(0, -1, 0, 0, 0, 1),
		parent: new Int32Array(2),
		ids: Uint32Array.of(0, 1),
		traits: sized([24, 24], [30, 40]),
	},
	internodes: {
		count: 1,
		parent: Int32Array.of(-1),
		kind: new Uint32Array(1),
		axis: Int32Array.of(-1),
		state: new Uint8Array(1),
		ends: inPixels(0, 0, 0, 3, -29, 5),
		radii: new Float32Array(2),
	},
};

/** The core's numbers are single-precision. */
function expectNear(found: readonly object[], expected: readonly object[]): void {
	const numbers = (shapes: readonly object[]) => shapes.flatMap((shape) => Object.values(shape) as number[]);
	expect(found.map(Object.keys)).toEqual(expected.map(Object.keys));
	for (const [index, value] of numbers(expected).entries()) expect(numbers(found)[index]).toBeCloseTo(value, 4);
}

describe("silhouette", () => {
	it("shows the front view from +Z: p3's side (+X) at the right, farthest first", () => {
		const { berries, stems } = silhouette(bunch, "front", 0.25);
		expectNear(berries, [
			{ x: -50, y: 200, rx: 15, ry: 15, turn: 0 },
			{ x: 30, y: 100, rx: 12, ry: 12, turn: Math.PI / 2 },
		]);
		expectNear(stems, [[0, 0, 3, 29]]);
	});

	it("shows the side view from −X: p5's side (+Z) at the right, farthest first", () => {
		const { berries, stems } = silhouette(bunch, "side", 0.25);
		expectNear(berries, [
			{ x: 40, y: 100, rx: 12, ry: 12, turn: Math.PI / 2 },
			{ x: -60, y: 200, rx: 20, ry: 15, turn: 0 },
		]);
		expectNear(stems, [[0, 0, 5, 29]]);
	});

	it("follows the scale, so that the drawing stays on the profile", () => {
		expectNear(silhouette(bunch, "front", 0.5).berries.slice(1), [{ x: 15, y: 50, rx: 6, ry: 6, turn: Math.PI / 2 }]);
	});
});
