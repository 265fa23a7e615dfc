import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
	clampPixels,
	dragHandle,
	mirrorFrontBack,
	mirrorLeftRight,
	nudgeHandle,
	setShapeValue,
	straightened,
} from "../../../../../web/src/models/bunch/profile/drag";
import {
	type BunchShape,
	type Handle,
	handleKeys,
	handleLabel,
	handlePosition,
	isSide,
	type ShapeKey,
	SIDES,
} from "../../../../../web/src/models/bunch/profile/handles";
import { anyHandle, anyShape, DEFAULTS, RANGES, SHAPE_KEYS } from "./shape";

const anyPoint = fc.record({ x: fc.double(), y: fc.double() });
const anyLocks = fc.record({ leftRight: fc.boolean(), frontBack: fc.boolean() });
const bothLocked = { leftRight: true, frontBack: true };

function expectInTable(shape: BunchShape) {
	for (const key of SHAPE_KEYS) {
		const { min, max } = RANGES.get(key) as { min: number; max: number };
		expect(shape[key]).toBeGreaterThanOrEqual(min);
		expect(shape[key]).toBeLessThanOrEqual(max);
		expect(Number.isInteger(shape[key])).toBe(true);
	}
}

function changedKeys(before: BunchShape, after: BunchShape): ShapeKey[] {
	return SHAPE_KEYS.filter((key) => before[key] !== after[key]);
}

describe("handle positions", () => {
	it("are the paper's: p2 below p1, p3 and p5 at the right of their view, p4 and p6 at the left", () => {
		const shape = { ...DEFAULTS, l: 377, p3w: 190, p3r: 130, p4w: 110, p4r: 150, p5w: 7, p5r: 8, p6w: 9, p6r: 10 };
		expect(handlePosition(shape, "p2")).toEqual({ x: 0, y: 377 });
		expect(handlePosition(shape, "p3")).toEqual({ x: 190, y: 130 });
		expect(handlePosition(shape, "p4")).toEqual({ x: -110, y: 150 });
		expect(handlePosition(shape, "p5")).toEqual({ x: 7, y: 8 });
		expect(handlePosition(shape, "p6")).toEqual({ x: -9, y: 10 });
	});

	it("are described in words", () => {
		expect(handleLabel(DEFAULTS, "p3")).toBe("p3, right: 64.7 mm wide, 64.7 mm below the top");
		expect(handleLabel({ ...DEFAULTS, unit: 0.5 }, "p4")).toBe("p4, left: 129.3 mm wide, 87.9 mm below the top");
		expect(handleLabel(DEFAULTS, "p2")).toBe("p2, length: 220.7 mm");
	});
});

describe("dragHandle", () => {
	it("puts the handle where it is dragged, anywhere the table allows", () => {
		fc.assert(
			fc.property(anyShape, anyShape, anyHandle, (shape, target, handle) => {
				const to = handlePosition(target, handle);
				expect(handlePosition(dragHandle(shape, handle, to), handle)).toEqual(to);
			}),
		);
	});

	it("gives whole pixels within the table for any point and any locks, never NaN", () => {
		fc.assert(
			fc.property(anyShape, anyHandle, anyPoint, anyLocks, fc.boolean(), (shape, handle, to, locks, mirror) => {
				expectInTable(dragHandle(shape, handle, to, { locks, mirror }));
			}),
		);
	});

	it("moves its own handle only, and its opposite if locked", () => {
		fc.assert(
			fc.property(anyShape, anyHandle, anyPoint, anyLocks, (shape, handle, to, locks) => {
				const allowed = handleKeys(handle);
				if (isSide(handle) && locks[SIDES[handle].lock]) allowed.push(...handleKeys(SIDES[handle].opposite));
				for (const key of changedKeys(shape, dragHandle(shape, handle, to, { locks }))) expect(allowed).toContain(key);
			}),
		);
	});

	it("keeps a locked pair mirror images of each other, and so does mirror without a lock", () => {
		const finite = fc.record({ x: fc.integer({ min: -900, max: 900 }), y: fc.integer({ min: -900, max: 900 }) });
		fc.assert(
			fc.property(anyShape, fc.constantFrom("p3", "p4", "p5", "p6"), finite, (shape, handle: Handle, to) => {
				for (const options of [{ locks: bothLocked }, { mirror: true }]) {
					const dragged = dragHandle(shape, handle, to, options);
					const here = handlePosition(dragged, handle);
					const there = handlePosition(dragged, SIDES[handle as "p3"].opposite);
					expect(there).toEqual({ x: 0 - here.x, y: here.y });
				}
			}),
		);
	});

	it("holds a side handle at the axis when it is dragged across, and the length at its ends", () => {
		expect(dragHandle(DEFAULTS, "p3", { x: -40, y: 90 })).toMatchObject({ p3w: 0, p3r: 90 });
		expect(dragHandle(DEFAULTS, "p4", { x: -999, y: -5 })).toMatchObject({ p4w: 290, p4r: 0 });
		expect(dragHandle(DEFAULTS, "p2", { x: 77, y: -5 }).l).toBe(29);
		expect(dragHandle(DEFAULTS, "p2", { x: 77, y: 9999 }).l).toBe(580);
	});

	it("lets a side's drop pass the tip", () => {
		expect(dragHandle({ ...DEFAULTS, l: 100 }, "p5", { x: 60, y: 300 })).toMatchObject({ p5r: 300, l: 100 });
	});

	it("keeps every other parameter and does not modify its input", () => {
		const before = Object.freeze({ ...DEFAULTS, seed: 7 });
		const after = dragHandle(before, "p6", { x: -20, y: 30 });
		expect(after).toEqual({ ...before, p6w: 20, p6r: 30 });
	});
});

describe("setShapeValue", () => {
	it("does the same as a slider: clamps, and sets the locked side too", () => {
		expect(setShapeValue(DEFAULTS, "p4r", 700)).toEqual({ ...DEFAULTS, p4r: 580 });
		expect(setShapeValue(DEFAULTS, "p4r", 33, { locks: bothLocked })).toEqual({ ...DEFAULTS, p4r: 33, p3r: 33 });
		expect(setShapeValue(DEFAULTS, "l", Number.NaN)).toBe(DEFAULTS);
	});

	it("never gives minus zero", () => {
		expect(Object.is(clampPixels("p3w", -0.2), 0)).toBe(true);
	});
});

describe("a drag with Shift", () => {
	it("keeps the handle on the level or the plumb line it started from, whichever is nearer", () => {
		expect(straightened({ x: 190, y: 160 }, { x: 150, y: 150 })).toEqual({ x: 190, y: 150 });
		expect(straightened({ x: 145, y: 92 }, { x: 150, y: 150 })).toEqual({ x: 150, y: 92 });
	});
});

describe("nudgeHandle", () => {
	it("moves a handle the way its arrow points on the screen", () => {
		expect(nudgeHandle(DEFAULTS, "p3", "ArrowRight", 1)).toEqual({ ...DEFAULTS, p3w: 151 });
		expect(nudgeHandle(DEFAULTS, "p4", "ArrowRight", 1)).toEqual({ ...DEFAULTS, p4w: 149 });
		expect(nudgeHandle(DEFAULTS, "p4", "ArrowUp", 10)).toEqual({ ...DEFAULTS, p4r: 92 });
		expect(nudgeHandle(DEFAULTS, "p2", "ArrowDown", 10)).toEqual({ ...DEFAULTS, l: 522 });
	});

	it("takes the opposite along where it is locked, and leaves the other number of a fractional profile alone", () => {
		const shape = { ...DEFAULTS, p5r: 150.25 };
		expect(nudgeHandle(shape, "p5", "ArrowLeft", 1)).toEqual({ ...shape, p5w: 149 });
		expect(nudgeHandle(shape, "p6", "ArrowDown", 1, { locks: bothLocked })).toEqual({ ...shape, p5r: 151, p6r: 151 });
	});

	it("returns undefined for other keys and for arrows along which p2 cannot move", () => {
		expect(nudgeHandle(DEFAULTS, "p2", "ArrowLeft", 1)).toBeUndefined();
		expect(nudgeHandle(DEFAULTS, "p3", "Enter", 1)).toBeUndefined();
	});

	it("there and back restores the profile, away from the ends of the range", () => {
		const inner = fc.constantFrom("p3", "p4", "p5", "p6", "p2") as fc.Arbitrary<Handle>;
		fc.assert(
			fc.property(inner, fc.constantFrom(1, 10), (handle, step) => {
				const down = nudgeHandle(DEFAULTS, handle, "ArrowDown", step) as typeof DEFAULTS;
				expect(nudgeHandle(down, handle, "ArrowUp", step)).toEqual(DEFAULTS);
			}),
		);
	});
});

describe("mirrors", () => {
	it("swap a pair; twice restores it", () => {
		fc.assert(
			fc.property(anyShape, (shape) => {
				for (const [mirror, a, b] of [
					[mirrorLeftRight, "p3", "p4"],
					[mirrorFrontBack, "p5", "p6"],
				] as const) {
					const once = mirror(shape);
					expect([once[`${a}w`], once[`${a}r`]]).toEqual([shape[`${b}w`], shape[`${b}r`]]);
					expect(mirror(once)).toEqual(shape);
				}
			}),
		);
	});
});
