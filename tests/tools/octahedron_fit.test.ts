import { describe, expect, it } from "vitest";
import { distance, inside, octahedronFit } from "../bench/octahedron_fit.mjs";

const square = [
	{ x: 0, y: 0 },
	{ x: 10, y: 0 },
	{ x: 10, y: 10 },
	{ x: 0, y: 10 },
];

describe("polygons", () => {
	it("hold what lies within them", () => {
		expect(inside(square, 5, 5)).toBe(true);
		expect(inside(square, 11, 5)).toBe(false);
		expect(inside(square, 5, -1)).toBe(false);
	});

	it("are as far as their nearest edge or corner", () => {
		expect(distance(square, 13, 5)).toBe(3);
		expect(distance(square, 13, 14)).toBe(5);
		expect(distance(square, 5, 4)).toBe(4);
	});
});

describe("octahedronFit", () => {
	const parameters = { l: 200, p3w: 50, p3r: 100, p4w: 50, p4r: 100, p5w: 50, p5r: 100, p6w: 50, p6r: 100 };
	const block = [
		{ x: -50, y: 0 },
		{ x: 50, y: 0 },
		{ x: 50, y: 200 },
		{ x: -50, y: 200 },
	];
	const half = block.map(({ x, y }) => ({ x: Math.max(x, 0), y }));

	it("covers half of the block about it and leaves it nowhere", () => {
		const { coverage, spill } = octahedronFit(parameters, [block, block], 5);
		expect(coverage).toBeCloseTo(0.5, 2);
		expect(spill).toBe(0);
	});

	it("spills by half where the outline is its right half, less what lies within a berry's radius", () => {
		expect(octahedronFit(parameters, [half, half], 0).spill).toBeCloseTo(0.5, 2);
		expect(octahedronFit(parameters, [half, block], 0).spill).toBeCloseTo(0.25, 2);
		// The part of a triangle of half width 50 beyond 10: (40 / 50)² of its half.
		expect(octahedronFit(parameters, [half, half], 10).spill).toBeCloseTo(0.32, 2);
	});
});
