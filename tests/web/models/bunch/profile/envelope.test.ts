import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { PROCEDURES } from "../../../../../web/src/models/bunch/bunch_plant";
import {
	endReach,
	envelopePath,
	filledWidth,
	sideEnvelope,
} from "../../../../../web/src/models/bunch/profile/envelope";
import type { Specimen } from "../../../bunch";
import { evenly } from "../../../evenly";
import { anyShape, DEFAULTS } from "./shape";

type Parameters = Specimen["parameters"];

const PAPER: Parameters = { ...DEFAULTS, procedure: PROCEDURES.indexOf("paper") };

/** Half-width of the envelope at a height, or NaN beyond its ends. */
function widthAt(points: { x: number; y: number }[], y: number): number {
	for (let i = 1; i < points.length; i++) {
		const [a, b] = [points[i - 1], points[i]];
		if (b.y >= y && b.y > a.y) return a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y);
	}
	return Number.NaN;
}

describe("sideEnvelope", () => {
	const points = sideEnvelope({ w: 150, r: 120, narrow: 50, first: 1 }, 512);
	/** rd as the formula gives it before it is rounded; axis rd leaves the rachis at the end of segment rd. */
	const waist = 29 * (120 * 0.056 + 1 + 1);

	it("starts at p1, passes through the handle and the narrow width at axis rd, ends at the tip", () => {
		expect(points[0]).toEqual({ x: 0, y: 0 });
		expect(points.at(-1)).toEqual({ x: expect.closeTo(0, 9), y: expect.closeTo(512, 9) });
		expect(widthAt(points, 120)).toBeCloseTo(150, 6);
		expect(widthAt(points, waist)).toBeCloseTo(50, 6);
	});

	it("is an ellipse above the handle, straight below it, constant to the tip and round there", () => {
		expect(widthAt(points, 120 * (1 - Math.sqrt(0.75)))).toBeCloseTo(75, 0);
		expect(widthAt(points, (120 + waist) / 2)).toBeCloseTo(100, 6);
		expect(widthAt(points, 400)).toBeCloseTo(50, 6);
		expect(widthAt(points, 512 - 50 * (1 - Math.sqrt(0.75)))).toBeCloseTo(25, 0);
	});

	it("never leaves its box, never turns back up, never is NaN", () => {
		fc.assert(
			fc.property(anyShape, fc.integer({ min: 0, max: 3 }), evenly(0, 300), (shape, first, narrow) => {
				const side = sideEnvelope({ w: shape.p3w, r: shape.p3r, narrow, first }, shape.l);
				let last = 0;
				for (const { x, y } of side) {
					expect(x).toBeGreaterThanOrEqual(0);
					expect(x).toBeLessThanOrEqual(shape.p3w);
					expect(y).toBeGreaterThanOrEqual(last - 1e-9);
					expect(y).toBeLessThanOrEqual(shape.l + 1e-9);
					last = y;
				}
			}),
		);
	});
});

describe("endReach", () => {
	it("is an end structure of L-system 3 with its berry: about 63 pixels with the paper's constants", () => {
		// (50 · 0.89 · 0.6 · 2.5 · sin 60° + 50) · 29/50
		expect(endReach({ ...PAPER, fit: 0 }, 150)).toBeCloseTo(62.53, 1);
	});

	it("is twig, pedicel and berry of a natural bunch, whatever the paper's constants", () => {
		// (sin 60° · (0.35 · 20 + 10) + 20) mm, at 0.25 · 50/29 mm to a pixel
		const natural = { ...DEFAULTS, size: 20, pedicel: 10 };
		expect(endReach(natural, 150)).toBeCloseTo(80.55, 1);
		expect(endReach({ ...natural, rmax: 80, li: 100 }, 150)).toBe(endReach(natural, 150));
		expect(endReach({ ...natural, unit: 0.5 }, 150)).toBeCloseTo(80.55 / 2, 1);
	});

	it("leaves a cylinder a cylinder and a raceme a raceme", () => {
		for (const parameters of [PAPER, DEFAULTS]) {
			expect(endReach(parameters, 47)).toBe(47);
			expect(endReach(parameters, 9)).toBe(9);
		}
	});
});

describe("filledWidth", () => {
	it("is at least half a berry, in a natural bunch", () => {
		const raceme = { p3w: 9, size: 18, unit: 0.25 };
		expect(filledWidth({ ...DEFAULTS, ...raceme }, "p3")).toBeCloseTo(9 / (0.25 * (50 / 29)), 6);
		expect(filledWidth({ ...DEFAULTS, ...raceme, p3w: 100 }, "p3")).toBe(100);
		expect(filledWidth({ ...PAPER, ...raceme }, "p3")).toBe(9);
	});
});

describe("envelopePath", () => {
	it("is one closed path, the right side at the right, whatever the profile", () => {
		fc.assert(
			fc.property(anyShape, fc.constantFrom("front", "side"), (shape, view: "front" | "side") => {
				const path = envelopePath({ ...PAPER, ...shape }, view);
				expect(path).toMatch(/^M-?[\d.]+ -?[\d.]+(L-?[\d.]+ -?[\d.]+)+Z$/);
				const xs = [...path.matchAll(/[ML](-?[\d.]+) /g)].map(([, x]) => Number(x));
				const [right, left] = view === "front" ? [shape.p3w, shape.p4w] : [shape.p5w, shape.p6w];
				expect(Math.max(...xs)).toBeCloseTo(right, 1);
				expect(Math.min(...xs)).toBeCloseTo(-left, 1);
			}),
		);
	});

	it("moves with every pixel, where the paper's counts step", () => {
		const paths = Array.from({ length: 40 }, (_, step) => envelopePath({ ...DEFAULTS, p4r: 100 + step }, "front"));
		expect(new Set(paths).size).toBe(paths.length);
	});
});
