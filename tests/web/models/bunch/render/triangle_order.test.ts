import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { triangleOrder } from "../../../../../web/src/models/bunch/render/triangle_order";
import { pressedBunch } from "../pressed_bunch";

/** Writes triangles from their least corner on, so that only connectivity and orientation matter. */
function triangles(indices: Uint32Array): string[] {
	const corners = (t: number) => [...indices.subarray(3 * t, 3 * t + 3)];
	const keyOf = (triangle: number[]) => {
		const first = triangle.indexOf(Math.min(...triangle));
		return [0, 1, 2].map((k) => triangle[(first + k) % 3]).join(" ");
	};
	return Array.from({ length: indices.length / 3 }, (_, t) => keyOf(corners(t))).sort();
}

/**
 * Counts the groups of four vertices processed by a renderer that draws 128 triangles at a time with a cache of 64
 * vertices.
 */
function fours(indices: Uint32Array): number {
	let count = 0;
	for (let first = 0; first < indices.length; first += 384) {
		const batch = indices.subarray(first, first + 384);
		const cached = new Map<number, number>();
		batch.forEach((vertex, at) => {
			if (cached.get(vertex % 64) === vertex) return;
			count++;
			for (const each of batch.subarray(at, at + 4)) cached.set(each % 64, each);
		});
	}
	return count;
}

/** Rows of `sides` squares, halved. */
function grid(rows: number, sides: number): Uint32Array {
	const indices = [];
	for (let row = 0; row < rows; row++) {
		for (let side = 0; side < sides; side++) {
			const a = row * (sides + 1) + side;
			const b = a + sides + 1;
			indices.push(a, a + 1, b, a + 1, b + 1, b);
		}
	}
	return Uint32Array.from(indices);
}

describe("triangleOrder", () => {
	it("keeps every triangle and the way round it", () => {
		const corner = fc.nat({ max: 40 });
		const some = fc.array(fc.uniqueArray(corner, { minLength: 3, maxLength: 3 }), { maxLength: 200 });
		fc.assert(
			fc.property(some, (corners) => {
				const indices = Uint32Array.from(corners.flat());
				expect(triangles(triangleOrder(indices))).toEqual(triangles(indices));
			}),
		);
		const { indices } = pressedBunch({ count: 2 }).surfaces ?? {};
		if (!indices) throw new Error("nothing to draw");
		expect(triangles(triangleOrder(indices))).toEqual(triangles(indices));
	});

	it("has vertices worked out in half as many fours", () => {
		const indices = grid(10, 22);
		expect(fours(triangleOrder(indices))).toBeLessThan(0.55 * fours(indices));
	});
});
