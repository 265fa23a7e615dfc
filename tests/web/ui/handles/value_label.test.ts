import { describe, expect, it } from "vitest";
import { labelExtent, labelPlace } from "../../../../web/src/ui/handles/value_label";

const FIELD = { width: 400, height: 300 };
const LABEL = labelExtent("2.1 m out, 3 m up");

/** From a handle's middle to the nearest point of a label. */
function apart(at: { x: number; y: number }, place: { x: number; y: number }): number {
	const x = Math.max(place.x, Math.min(at.x, place.x + LABEL.width));
	const y = Math.max(place.y, Math.min(at.y, place.y + LABEL.height));
	return Math.hypot(at.x - x, at.y - y);
}

describe("a label beside a handle", () => {
	it("is placed away from the middle of the drawing", () => {
		const right = labelPlace({ x: 250, y: 150 }, LABEL, FIELD, []);
		expect(right.x).toBeGreaterThan(250);
		const left = labelPlace({ x: 150, y: 150 }, LABEL, FIELD, []);
		expect(left.x + LABEL.width).toBeLessThan(150);
		const above = labelPlace({ x: 200, y: 60 }, LABEL, FIELD, []);
		expect(above.y + LABEL.height).toBeLessThan(60);
	});

	it("never covers its own handle, nor leaves the field", () => {
		for (let x = 0; x <= FIELD.width; x += 20) {
			for (let y = 0; y <= FIELD.height; y += 20) {
				const place = labelPlace({ x, y }, LABEL, FIELD, []);
				expect(apart({ x, y }, place)).toBeGreaterThanOrEqual(9);
				expect(place.x).toBeGreaterThanOrEqual(0);
				expect(place.y).toBeGreaterThanOrEqual(0);
				expect(place.x + LABEL.width).toBeLessThanOrEqual(FIELD.width);
				expect(place.y + LABEL.height).toBeLessThanOrEqual(FIELD.height);
			}
		}
	});

	it("covers no other handle", () => {
		const at = { x: 250, y: 150 };
		const alone = labelPlace(at, LABEL, FIELD, []);
		const others = [
			{ x: alone.x + LABEL.width / 2, y: alone.y + LABEL.height / 2 },
			{ x: 300, y: 130 },
		];
		const place = labelPlace(at, LABEL, FIELD, others);
		for (const other of [at, ...others]) expect(apart(other, place)).toBeGreaterThanOrEqual(9);
	});
});
