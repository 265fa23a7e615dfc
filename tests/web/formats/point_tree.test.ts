import { describe, expect, it } from "vitest";
import { PointTree } from "../../../web/src/formats/point_tree";

/** Numbers between 0 and 1, the same every time. */
function numbers(count: number, seed: number): Float32Array {
	let state = seed;
	return Float32Array.from({ length: count }, () => {
		state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
		return state / 2 ** 32;
	});
}

describe("a tree of points", () => {
	it.each([1, 2, 3, 200])("finds the nearest of %i points, as a search through all of them does", (count) => {
		// Coordinates on a grid: many are equal.
		const points = numbers(3 * count, 1).map((value) => Math.round(8 * value) / 8);
		const tree = new PointTree(points);
		const places = numbers(300, 2);
		for (let at = 0; at < places.length; at += 3) {
			const distanceTo = (point: number) => Math.hypot(...[0, 1, 2].map((k) => points[3 * point + k] - places[at + k]));
			const least = Math.min(...Array.from({ length: count }, (_, point) => distanceTo(point)));
			expect(distanceTo(tree.nearest(places[at], places[at + 1], places[at + 2]))).toBeCloseTo(least, 12);
		}
	});
});
