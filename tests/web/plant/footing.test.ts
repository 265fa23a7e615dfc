import { describe, expect, it } from "vitest";
import { footingOf, MAX_STEMS, openBesideStem } from "../../../web/src/plant/footing";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";

/** A plant of upright stems without branches: x and radius each, 10 m high, and leaves of 0.1 m at a height. */
function plantOf(stems: readonly (readonly [x: number, radius: number])[], leaves = 0, high = 8) {
	return {
		segments: {
			...EMPTY_PLANT.segments,
			count: stems.length,
			ends: Float32Array.from(stems.flatMap(([x]) => [x, 0, 0, x, 10, 0])),
			radii: Float32Array.from(stems.flatMap(([, radius]) => [radius, 0.01])),
			parent: Int32Array.from(stems, () => -1),
		},
		organs: {
			...EMPTY_PLANT.organs,
			count: leaves,
			transforms: Float32Array.from(
				Array.from({ length: leaves }, (_, i) => [Math.cos(i), high, Math.sin(i), 0, 0, 0, 1, 0.1]).flat(),
			),
		},
	};
}

describe("footingOf", () => {
	it("returns the middle of the stems, thickest first, and the plant's size", () => {
		const footing = footingOf(
			plantOf([
				[-1, 0.1],
				[3, 0.3],
			]),
		);
		expect(footing?.centre).toEqual([1, 0, 0]);
		expect(footing?.stems.map(({ x }) => x)).toEqual([3, -1]);
		expect(footing?.height).toBeCloseTo(10);
		expect(footing?.reach).toBeCloseTo(2);
		expect(footing?.cover).toBe(0);
	});

	it("returns no more stems than the ground can show", () => {
		const many = Array.from({ length: 20 }, (_, i) => [i, 0.1] as const);
		expect(footingOf(plantOf(many))?.stems).toHaveLength(MAX_STEMS);
	});

	it("is undefined for a plant that grows downwards, and for one without stems", () => {
		const { segments, organs } = plantOf([[0, 0.1]]);
		const hanging = { ...segments, ends: segments.ends.map((value) => -value) };
		expect(footingOf({ segments: hanging, organs })).toBeUndefined();
		expect(footingOf(EMPTY_PLANT)).toBeUndefined();
	});

	it("hides more of the sky with more leaves, but never all; leaves on the ground hide nothing", () => {
		const covers = [0, 100, 1000, 10_000].map(
			(leaves) =>
				footingOf(
					plantOf(
						[
							[0, 0.1],
							[1, 0.1],
						],
						leaves,
					),
				)?.cover ?? 0,
		);
		expect(covers).toEqual([...covers].sort((one, other) => one - other));
		expect(covers[0]).toBe(0);
		expect(covers[3]).toBeLessThanOrEqual(1);
		expect(covers[1]).toBeGreaterThan(0);
		expect(
			footingOf(
				plantOf(
					[
						[0, 0.1],
						[1, 0.1],
					],
					1000,
					0.1,
				),
			)?.cover,
		).toBe(0);
	});
});

describe("openBesideStem", () => {
	it("is half of the sky at the bark, and rises to all of it far away", () => {
		const shares = [0.5, 0.75, 1, 2, 100].map((distance) => openBesideStem(0.5, distance));
		expect(shares[0]).toBeCloseTo(0.5);
		for (let i = 1; i < shares.length; i++) expect(shares[i]).toBeGreaterThan(shares[i - 1]);
		expect(shares[4]).toBeGreaterThan(0.99);
	});

	it("agrees with a sum over directions of the sky", () => {
		const [radius, distance, steps] = [0.3, 0.8, 100_000];
		let open = 0;
		for (let i = 0; i < steps; i++) {
			// The stem is tall: whether it hides a direction depends on the azimuth alone.
			const azimuth = (2 * Math.PI * (i + 0.5)) / steps;
			const hides = Math.cos(azimuth) > 0 && Math.abs(Math.sin(azimuth) * distance) < radius;
			if (!hides) open++;
		}
		expect(openBesideStem(radius, distance)).toBeCloseTo(open / steps, 4);
	});
});
