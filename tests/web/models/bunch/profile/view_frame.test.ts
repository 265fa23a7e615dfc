import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { PROCEDURES } from "../../../../../web/src/models/bunch/bunch_plant";
import { HANDLES, handlePosition, UNITS_PER_PIXEL } from "../../../../../web/src/models/bunch/profile/handles";
import { scaleBar, viewExtent, viewFrame, withRoomFor } from "../../../../../web/src/models/bunch/profile/view_frame";
import { evenly } from "../../../evenly";
import { anyShape, DEFAULTS } from "./shape";

describe("viewExtent", () => {
	const lychee = { ...DEFAULTS, l: 65, p3w: 42, p3r: 33, p4w: 52, p4r: 33, p5w: 43, p5r: 51, p6w: 44, p6r: 48 };

	it("is the paper's 600 pixels for a long bunch, less for a small one", () => {
		expect(viewExtent(DEFAULTS, 300, 300)).toBe(600);
		expect(viewExtent(lychee, 300, 300)).toBe(250);
	});

	it("leaves room for the berries there are, as each procedure sizes them", () => {
		const paper = { ...lychee, procedure: PROCEDURES.indexOf("paper") };
		expect(viewExtent({ ...paper, rmax: 10 }, 300, 300)).toBe(200);
		expect(viewExtent({ ...paper, rmax: 60 }, 300, 300)).toBe(300);
		expect(viewExtent({ ...lychee, rmax: 60, size: 6 }, 300, 300)).toBe(200);
		expect(viewExtent({ ...lychee, rmax: 10, size: 35 }, 300, 300)).toBe(300);
		expect(viewExtent({ ...lychee, unit: 1, size: 24 }, 300, 300)).toBe(200);
	});

	it("holds the berry below the tip of a long, narrow bunch", () => {
		const needle = { ...DEFAULTS, p3w: 10, p4w: 10, p5w: 10, p6w: 10, p3r: 50, p4r: 50, p5r: 50, p6r: 50 };
		const berry = needle.size / needle.unit / UNITS_PER_PIXEL;
		for (let l = 60; l <= 480; l += 10) {
			const frame = viewFrame(300, 300, viewExtent({ ...needle, l }, 300, 300));
			expect(frame.top + frame.height).toBeGreaterThan(l + berry);
		}
		// Ten pixels of the profile are not enough for it: a wider view is.
		expect(viewExtent({ ...needle, l: 240 }, 300, 300)).toBe(300);
	});

	it("holds the seed's own bunch as well, be it longer than any handle goes", () => {
		const own = { ...lychee, l: 90, p3w: 30, p5w: 110 };
		expect(withRoomFor(lychee, own)).toEqual({ ...lychee, l: 90, p5w: 110 });
		expect(withRoomFor(lychee)).toEqual(lychee);
		expect(viewExtent(withRoomFor(DEFAULTS, { ...DEFAULTS, l: 745 }), 300, 300)).toBe(860);
	});

	it("uses an element's height where it is higher than wide", () => {
		expect(viewExtent(DEFAULTS, 260, 305)).toBe(500);
		expect(viewExtent({ ...DEFAULTS, p6w: 290 }, 260, 305)).toBe(600);
	});

	it("holds every handle in the element, whatever its proportions", () => {
		const side = fc.integer({ min: 120, max: 900 });
		fc.assert(
			fc.property(anyShape, side, side, (shape, width, height) => {
				const frame = viewFrame(width, height, viewExtent({ ...DEFAULTS, ...shape }, width, height));
				for (const handle of HANDLES) {
					const { x, y } = handlePosition(shape, handle);
					expect(x).toBeGreaterThan(frame.left);
					expect(x).toBeLessThan(frame.left + frame.width);
					expect(y).toBeLessThan(frame.top + frame.height);
				}
			}),
		);
	});
});

describe("viewFrame", () => {
	it("shows the whole square in an element of any proportions, p1 in the middle of its top", () => {
		fc.assert(
			fc.property(fc.integer({ min: 60, max: 900 }), fc.integer({ min: 60, max: 900 }), (width, height) => {
				const { left, top, scale, ...size } = viewFrame(width, height, 600);
				expect(size.width * scale).toBeCloseTo(width, 6);
				expect(size.height * scale).toBeCloseTo(height, 6);
				expect(left + size.width / 2).toBeCloseTo(0, 6);
				expect(top).toBeLessThan(0);
				expect(left).toBeLessThan(-300);
				expect(top + size.height).toBeGreaterThan(600);
			}),
		);
	});

	it("stays finite in an element without size", () => {
		for (const value of Object.values(viewFrame(0, 0, 600))) expect(Number.isFinite(value)).toBe(true);
	});
});

describe("scaleBar", () => {
	it("is a round length in its unit", () => {
		expect(scaleBar(600, 0.25)).toEqual({ label: "5 cm", length: expect.closeTo(116, 9) });
		expect(scaleBar(150, 0.05)).toEqual({ label: "2 mm", length: expect.closeTo(23.2, 9) });
		expect(scaleBar(600, 2).label).toBe("50 cm");
		expect(scaleBar(120, 0.25).label).toBe("1 cm");
	});

	it("takes between a tenth and a quarter of the view", () => {
		fc.assert(
			fc.property(fc.constantFrom(150, 300, 600), evenly(0.05, 2), (extent, unit) => {
				const { length } = scaleBar(extent, unit);
				expect(length).toBeLessThanOrEqual(extent / 4 + 1e-9);
				expect(length).toBeGreaterThanOrEqual(extent / 10 - 1e-9);
			}),
		);
	});
});
