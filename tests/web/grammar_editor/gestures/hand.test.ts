import { describe, expect, it } from "vitest";
import { HandReader } from "../../../../web/src/grammar_editor/gestures/hand";

/**
 * Landmarks of an upright hand as the camera sees it: wrist to knuckle spans a tenth of the picture, and the palm's
 * centre is at (x, y).
 */
function handAt(x: number, y: number, apart = 0.1) {
	const points = Array.from({ length: 21 }, () => ({ x, y }));
	points[0] = { x, y: y + 0.06 };
	points[5] = { x: x - 0.03, y: y - 0.03 };
	points[17] = { x: x + 0.03, y: y - 0.03 };
	points[9] = { x, y: y - 0.04 };
	points[4] = { x: x - 0.05, y };
	points[8] = { x: x - 0.05 + apart, y };
	return points;
}

describe("a hand before the camera", () => {
	it("moves right as the person's hand does, and reaches both ends of the range within the picture", () => {
		const at = (x: number, y: number) => new HandReader().read(handAt(x, y), 1);
		expect(at(0.5, 0.5)).toMatchObject({ x: 0.5, y: 0.5 });
		expect(at(0.75, 0.3)?.x).toBeLessThan(0.2);
		expect(at(0.2, 0.3)?.x).toBeGreaterThan(0.8);
		expect(at(0.1, 0.12)).toMatchObject({ x: 1, y: 0 });
		expect(at(0.9, 0.88)).toMatchObject({ x: 0, y: 1 });
	});

	it("pinches once, until the fingers open again", () => {
		const reader = new HandReader();
		let seconds = 0;
		const pinched = (apart: number) => {
			seconds += 0.05;
			return reader.read(handAt(0.5, 0.5, apart), seconds)?.pinched;
		};
		expect([0.1, 0.02, 0.01, 0.04, 0.02, 0.1, 0.02].map(pinched)).toEqual([
			false,
			true,
			false,
			false,
			false,
			false,
			true,
		]);
	});

	it("is smoothed at rest, and follows fast movements", () => {
		const reader = new HandReader();
		const steps = Array.from({ length: 60 }, (_, i) => reader.read(handAt(0.5 + 0.004 * (i % 2), 0.5), i / 30)?.x ?? 0);
		const late = steps.slice(30);
		expect(Math.max(...late) - Math.min(...late)).toBeLessThan(0.004);
		let last = 0;
		for (let i = 0; i < 15; i++) last = reader.read(handAt(0.25, 0.5), 2 + i / 30)?.x ?? 0;
		expect(last).toBeGreaterThan(0.85);
	});

	it("returns undefined without landmarks, or with invalid numbers", () => {
		const reader = new HandReader();
		expect(reader.read(undefined, 0)).toBeUndefined();
		expect(reader.read(handAt(0.5, 0.5).slice(1), 0)).toBeUndefined();
		expect(reader.read(handAt(Number.NaN, 0.5), 0)).toBeUndefined();
		expect(reader.read(handAt(0.5, 0.5), 0)).toMatchObject({ x: 0.5, y: 0.5 });
	});
});
