import { describe, expect, it } from "vitest";
import { isFree, placeHint, type ScreenBox } from "../../../../web/src/app/hints/place_hint";

const box = (left: number, top: number, width: number, height: number): ScreenBox => ({ left, top, width, height });
const HINT = { width: 200, height: 80 };
const BOUNDS = box(0, 0, 600, 400);

const meet = (a: ScreenBox, b: ScreenBox) =>
	a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;

describe("a hint", () => {
	it("is placed beside its target, within the area", () => {
		const target = box(300, 180, 44, 44);
		const place = placeHint(HINT, { target, bounds: BOUNDS, controls: [], others: [] });
		if (!place) throw new Error("no place");
		const hint = { ...place, ...HINT };
		expect(meet(hint, target)).toBe(false);
		const [dx, dy] = [hint.left + 100 - 322, hint.top + 40 - 202];
		expect(Math.abs(dx) < 150 || Math.abs(dy) < 90).toBe(true);
		expect(isFree(HINT, place, { target, bounds: BOUNDS, controls: [], others: [] })).toBe(true);
	});

	it("covers no control, and other elements only where there is no other place", () => {
		const target = box(10, 370, 30, 30);
		const controls = [box(0, 250, 150, 120), box(400, 0, 200, 400)];
		const others = [box(0, 300, 600, 100)];
		const around = { target, bounds: BOUNDS, controls, others };
		const first = placeHint(HINT, around);
		if (!first) throw new Error("no place");
		for (const each of [...controls, ...others]) expect(meet({ ...first, ...HINT }, each)).toBe(false);
		const full = { ...around, controls: [...controls, box(0, 0, 400, 250)] };
		const second = placeHint(HINT, full);
		if (!second) throw new Error("no place");
		for (const each of full.controls) expect(meet({ ...second, ...HINT }, each)).toBe(false);
		expect(meet({ ...second, ...HINT }, others[0])).toBe(true);
	});

	it("is not placed where there is no room", () => {
		const around = { target: box(0, 0, 10, 10), bounds: box(0, 0, 180, 400), controls: [], others: [] };
		expect(placeHint(HINT, around)).toBeUndefined();
		const covered = { ...around, bounds: BOUNDS, controls: [box(0, 90, 600, 220)] };
		expect(placeHint(HINT, covered)).toBeUndefined();
	});

	it("has to move when another element comes to its place, such as the scale bar, which is loaded later", () => {
		const around = { target: box(0, 400, 0, 0), bounds: BOUNDS, controls: [], others: [] };
		const place = placeHint(HINT, around);
		if (!place) throw new Error("no place");
		const scaleBar = box(20, 360, 140, 30);
		expect(isFree(HINT, place, { ...around, others: [scaleBar] })).toBe(false);
		const next = placeHint(HINT, { ...around, others: [scaleBar] });
		if (!next) throw new Error("no place");
		expect(meet({ ...next, ...HINT }, scaleBar)).toBe(false);
	});

	it("has to move when a control comes to its place, or the area becomes smaller", () => {
		const around = { target: box(0, 0, 10, 10), bounds: BOUNDS, controls: [], others: [] };
		const place = { left: 100, top: 100 };
		expect(isFree(HINT, place, around)).toBe(true);
		expect(isFree(HINT, place, { ...around, controls: [box(290, 170, 20, 20)] })).toBe(false);
		expect(isFree(HINT, place, { ...around, bounds: box(0, 0, 299, 400) })).toBe(false);
	});
});
