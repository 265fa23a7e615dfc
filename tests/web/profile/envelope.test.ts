import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { drawnPlan, endReach, envelopePath, sideEnvelope } from "../../../web/src/profile/envelope";
import type { Shape } from "../../../web/src/profile/handles";
import { anyShape, DEFAULTS } from "./shape";

/** Rows of Table 3: l, m, then w r n rd for p3 … p6. */
const TABLE_3: [l: number, m: number, sides: [w: number, r: number, n: number, rd: number][]][] = [
	[
		253,
		9,
		[
			[79, 76, 3, 4],
			[116, 91, 5, 6],
			[101, 112, 4, 8],
			[97, 103, 4, 8],
		],
	],
	[
		377,
		13,
		[
			[190, 130, 8, 7],
			[110, 150, 4, 9],
			[150, 150, 6, 10],
			[150, 150, 6, 11],
		],
	],
	[
		528,
		18,
		[
			[9, 17, 0, 1],
			[10, 19, 0, 2],
			[10, 17, 0, 3],
			[9, 16, 0, 4],
		],
	],
	[
		65,
		2,
		[
			[42, 33, 2, 1],
			[52, 33, 2, 1],
			[43, 51, 2, 1],
			[44, 48, 2, 1],
		],
	],
];

function shapeOf(l: number, sides: [number, number, number, number][]): Shape {
	const [[p3w, p3r], [p4w, p4r], [p5w, p5r], [p6w, p6r]] = sides;
	return { l, p3w, p3r, p4w, p4r, p5w, p5r, p6w, p6r };
}

/** Half-width of the envelope at a height, or NaN beyond its ends. */
function widthAt(points: { x: number; y: number }[], y: number): number {
	for (let i = 1; i < points.length; i++) {
		const [a, b] = [points[i - 1], points[i]];
		if (b.y >= y && b.y > a.y) return a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y);
	}
	return Number.NaN;
}

describe("drawnPlan", () => {
	it("gives rows of Table 3", () => {
		for (const [l, m, sides] of TABLE_3) {
			const plan = drawnPlan({ ...DEFAULTS, ...shapeOf(l, sides) });
			expect(plan.m).toBe(m);
			expect(plan.sides.map(({ w, r, n, rd }) => [w, r, n, rd])).toEqual(sides);
		}
	});
});

describe("sideEnvelope", () => {
	const points = sideEnvelope({ w: 150, r: 120, rd: 8 }, 512, 18, 50);

	it("starts at p1, passes through the handle and the narrow width at axis rd, ends at the tip", () => {
		expect(points[0]).toEqual({ x: 0, y: 0 });
		expect(points.at(-1)).toEqual({ x: expect.closeTo(0, 9), y: expect.closeTo(512, 9) });
		expect(widthAt(points, 120)).toBeCloseTo(150, 6);
		expect(widthAt(points, (512 * 9) / 18)).toBeCloseTo(50, 6);
	});

	it("is an ellipse above the handle, straight below it, constant to the tip and round there", () => {
		expect(widthAt(points, 120 * (1 - Math.sqrt(0.75)))).toBeCloseTo(75, 0);
		expect(widthAt(points, (120 + 256) / 2)).toBeCloseTo(100, 6);
		expect(widthAt(points, 400)).toBeCloseTo(50, 6);
		expect(widthAt(points, 512 - 50 * (1 - Math.sqrt(0.75)))).toBeCloseTo(25, 0);
	});

	it("never leaves its box, never turns back up, never is NaN", () => {
		fc.assert(
			fc.property(
				anyShape,
				fc.integer({ min: 0, max: 19 }),
				fc.double({ min: 0, max: 300, noNaN: true }),
				(shape, rd, narrow) => {
					const m = drawnPlan({ ...DEFAULTS, ...shape }).m;
					const side = sideEnvelope({ w: shape.p3w, r: shape.p3r, rd }, shape.l, m, narrow);
					let last = 0;
					for (const { x, y } of side) {
						expect(x).toBeGreaterThanOrEqual(0);
						expect(x).toBeLessThanOrEqual(shape.p3w);
						expect(y).toBeGreaterThanOrEqual(last - 1e-9);
						expect(y).toBeLessThanOrEqual(shape.l + 1e-9);
						last = y;
					}
				},
			),
		);
	});
});

describe("endReach", () => {
	it("is an end structure of L-system 3 with its berry: about 63 pixels with the paper's constants", () => {
		// (50 · 0.89 · 0.6 · 2.5 · sin 60° + 50) · 29/50
		expect(endReach({ ...DEFAULTS, fit: 0 }, { w: 150, n: 6 })).toBeCloseTo(62.53, 1);
	});

	it("leaves a cylinder a cylinder and a raceme a raceme", () => {
		expect(endReach(DEFAULTS, { w: 47, n: 2 })).toBe(47);
		expect(endReach(DEFAULTS, { w: 9, n: 0 })).toBe(9);
	});
});

describe("envelopePath", () => {
	it("is one closed path, the right side at the right, whatever the profile", () => {
		fc.assert(
			fc.property(anyShape, fc.constantFrom("front", "side"), (shape, view: "front" | "side") => {
				const path = envelopePath({ ...DEFAULTS, ...shape }, view);
				expect(path).toMatch(/^M-?[\d.]+ -?[\d.]+(L-?[\d.]+ -?[\d.]+)+Z$/);
				const xs = [...path.matchAll(/[ML](-?[\d.]+) /g)].map(([, x]) => Number(x));
				const [right, left] = view === "front" ? [shape.p3w, shape.p4w] : [shape.p5w, shape.p6w];
				expect(Math.max(...xs)).toBeCloseTo(right, 1);
				expect(Math.min(...xs)).toBeCloseTo(-left, 1);
			}),
		);
	});

	it("takes its counts from the plan that grew, its sizes from what is under the finger", () => {
		const plan = drawnPlan(DEFAULTS);
		const narrowed = { ...plan, sides: plan.sides.map((side) => ({ ...side, rd: 3 })) as typeof plan.sides };
		expect(envelopePath(DEFAULTS, "front", narrowed)).not.toBe(envelopePath(DEFAULTS, "front", plan));
		expect(envelopePath({ ...DEFAULTS, l: 400 }, "front", plan)).toContain(" 400.0");
	});
});
