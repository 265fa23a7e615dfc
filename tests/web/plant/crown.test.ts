import { describe, expect, it } from "vitest";
import { bentNormal, crownOf, outwards } from "../../../web/src/plant/crown";
import type { Vector } from "../../../web/src/plant/part";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";

/** Leaves on a grid inside an ellipsoid about (1, 5, 2) that is 4 m wide and 6 m high. */
function leaves(): Float32Array {
	const placed: number[] = [];
	for (let x = -1; x <= 1; x += 0.1)
		for (let y = -1; y <= 1; y += 0.1)
			for (let z = -1; z <= 1; z += 0.1)
				if (x * x + y * y + z * z <= 1) placed.push(1 + 2 * x, 5 + 3 * y, 2 + 2 * z, 0, 0, 0, 1, 0.1);
	return Float32Array.from(placed);
}

const transforms = leaves();
const organs = { ...EMPTY_PLANT.organs, count: transforms.length / 8, transforms };
const length = (v: Vector) => Math.hypot(...v);
const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

describe("crownOf", () => {
	it("returns the ellipsoid that evenly spread leaves fill", () => {
		const crown = crownOf({ organs });
		expect(crown?.centre.map((value) => Math.round(100 * value) / 100)).toEqual([1, 5, 2]);
		expect(crown?.breadth).toBeCloseTo(2, 1);
		expect(crown?.height).toBeCloseTo(3, 1);
	});

	it("is undefined without leaves", () => {
		expect(crownOf(EMPTY_PLANT)).toBeUndefined();
	});
});

describe("bentNormal", () => {
	const crown = crownOf({ organs });
	if (!crown) throw new Error("There is a crown.");

	it("has unit length, and is nearer to the crown's outward direction than the leaf's own normal is", () => {
		for (const point of [
			[3, 5, 2],
			[1, 8, 2],
			[0, 4, 3],
		] as Vector[])
			for (const normal of [
				[0, 1, 0],
				[0, 0.6, 0.8],
			] as Vector[]) {
				const bent = bentNormal(crown, point, normal);
				expect(length(bent)).toBeCloseTo(1);
				expect(dot(bent, outwards(crown, point))).toBeGreaterThanOrEqual(dot(normal, outwards(crown, point)) - 1e-9);
			}
	});

	it("points up at the centre", () => {
		expect(outwards(crown, crown.centre)).toEqual([0, 1, 0]);
	});
});
