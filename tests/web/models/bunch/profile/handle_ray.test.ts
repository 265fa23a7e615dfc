import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { dragHandle } from "../../../../../web/src/models/bunch/profile/drag";
import {
	type BunchVector,
	type HandleRay,
	handleVector,
	rayToView,
	visibleFreedom,
} from "../../../../../web/src/models/bunch/profile/handle_ray";
import { handlePosition, metresPerPixel } from "../../../../../web/src/models/bunch/profile/handles";
import { evenly } from "../../../evenly";
import { anyHandle, anyShape, DEFAULTS } from "./shape";

const UNIT = 0.25;
const PIXEL = metresPerPixel(UNIT);

function rayTo(eye: BunchVector, target: BunchVector): HandleRay {
	return { origin: eye, direction: [target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]] };
}

/** Eyes around the bunch, half a metre to a metre and a half away, not straight above or below. */
const anyEye: fc.Arbitrary<BunchVector> = fc
	.record({
		angle: evenly(-Math.PI, Math.PI),
		height: evenly(-0.5, 0.5),
		distance: evenly(0.5, 1.5),
	})
	.map(({ angle, height, distance }) => [distance * Math.sin(angle), height, distance * Math.cos(angle)]);

describe("handleVector", () => {
	it("puts p3 at +X, p4 at −X, p5 at +Z, p6 at −Z and p2 below, 29 pixels being 12.5 mm", () => {
		const shape = { ...DEFAULTS, l: 29, p3w: 58, p3r: 29, p4w: 58, p4r: 0, p5w: 58, p5r: 29, p6w: 58, p6r: 29 };
		const expected: [Parameters<typeof handleVector>[1], BunchVector][] = [
			["p2", [0, -0.0125, 0]],
			["p3", [0.025, -0.0125, 0]],
			["p4", [-0.025, 0, 0]],
			["p5", [0, -0.0125, 0.025]],
			["p6", [0, -0.0125, -0.025]],
		];
		for (const [handle, place] of expected) {
			for (const [i, value] of handleVector(shape, handle, UNIT).entries()) expect(value).toBeCloseTo(place[i], 12);
		}
	});
});

describe("rayToView", () => {
	it("of the ray through the handle is the handle, from wherever it is seen", () => {
		fc.assert(
			fc.property(anyShape, anyHandle, anyEye, (shape, handle, eye) => {
				const ray = rayTo(eye, handleVector(shape, handle, UNIT));
				const point = rayToView(shape, handle, visibleFreedom(handle, ray), ray, UNIT);
				const place = handlePosition(shape, handle);
				expect(point?.x).toBeCloseTo(place.x, 6);
				expect(point?.y).toBeCloseTo(place.y, 6);
			}),
		);
	});

	it("of the ray through another place of a side's plane is that place, so that a drag reads back", () => {
		fc.assert(
			fc.property(anyShape, anyShape, anyHandle, anyEye, (shape, target, handle, eye) => {
				const grab = rayTo(eye, handleVector(shape, handle, UNIT));
				const freedom = visibleFreedom(handle, grab);
				fc.pre(freedom === "plane");
				const point = rayToView(shape, handle, freedom, rayTo(eye, handleVector(target, handle, UNIT)), UNIT);
				if (!point) throw new Error("the plane lies before the eye");
				const dragged = dragHandle(shape, handle, point);
				expect(handlePosition(dragged, handle)).toEqual(handlePosition(target, handle));
			}),
		);
	});

	it("moves p2 along the plumb line only", () => {
		const eye: BunchVector = [0.3, 0.1, 0.6];
		const ray = rayTo(eye, [0, -300 * PIXEL, 0]);
		expect(visibleFreedom("p2", ray)).toBe("plumb");
		expect(rayToView(DEFAULTS, "p2", "plumb", ray, UNIT)).toEqual({ x: 0, y: expect.closeTo(300, 6) });
	});

	it("does not depend on how long the ray's direction is", () => {
		const factor = evenly(0.01, 100);
		fc.assert(
			fc.property(anyShape, anyHandle, anyEye, factor, (shape, handle, eye, longer) => {
				const ray = rayTo(eye, handleVector(shape, handle, UNIT));
				const stretched = { ...ray, direction: ray.direction.map((value) => value * longer) as unknown as BunchVector };
				const freedom = visibleFreedom(handle, ray);
				expect(visibleFreedom(handle, stretched)).toBe(freedom);
				const [one, other] = [ray, stretched].map((each) => rayToView(shape, handle, freedom, each, UNIT));
				expect(other?.x).toBeCloseTo(one?.x ?? Number.NaN, 3);
				expect(other?.y).toBeCloseTo(one?.y ?? Number.NaN, 3);
			}),
		);
	});

	it.each(["plane", "plumb", "level"] as const)("is nothing where the %s lies behind the eye", (freedom) => {
		const away: HandleRay = { origin: [0.05, -0.1, 0.6], direction: [0.1, 0.05, 1] };
		expect(rayToView(DEFAULTS, "p3", freedom, away, UNIT)).toBeUndefined();
		const towards: HandleRay = { origin: [0.05, -0.1, 0.6], direction: [-0.1, -0.05, -1] };
		expect(rayToView(DEFAULTS, "p3", freedom, towards, UNIT)).toBeDefined();
	});

	it("never is NaN", () => {
		const any = fc.tuple(fc.double(), fc.double(), fc.double());
		fc.assert(
			fc.property(anyShape, anyHandle, any, any, (shape, handle, origin, direction) => {
				const ray = { origin, direction };
				const point = rayToView(shape, handle, visibleFreedom(handle, ray), ray, UNIT);
				if (!point) return;
				const dragged = dragHandle({ ...DEFAULTS, ...shape }, handle, point);
				for (const value of Object.values(dragged)) expect(Number.isFinite(value)).toBe(true);
			}),
		);
	});
});

describe("visibleFreedom", () => {
	const centre: BunchVector = [0, -0.1, 0];

	it("is the whole plane from the front and at a slant", () => {
		for (const eye of [
			[0, -0.1, 0.6],
			[0.4, 0.2, 0.4],
		] as BunchVector[]) {
			expect(visibleFreedom("p3", rayTo(eye, centre))).toBe("plane");
		}
	});

	it("is the plumb line where the plane is seen edge-on from the side, and its width then stays", () => {
		const eye: BunchVector = [0.6, -0.1, 0];
		expect(visibleFreedom("p3", rayTo(eye, centre))).toBe("plumb");
		const ray = rayTo(eye, [150 * PIXEL, -200 * PIXEL, 0.002]);
		expect(rayToView(DEFAULTS, "p3", "plumb", ray, UNIT)).toEqual({ x: 150, y: expect.closeTo(200, 2) });
		expect(visibleFreedom("p5", rayTo(eye, centre))).toBe("plane");
	});

	it("is the level where it is seen from above, and its drop then stays", () => {
		const eye: BunchVector = [0, 0.6, 0];
		expect(visibleFreedom("p5", rayTo(eye, centre))).toBe("level");
		const ray = rayTo(eye, [0.002, -150 * PIXEL, 80 * PIXEL]);
		expect(rayToView(DEFAULTS, "p5", "level", ray, UNIT)).toEqual({ x: expect.closeTo(80, 1), y: 150 });
	});

	it("is undefined for a handle behind the camera or a line seen end-on", () => {
		const away: HandleRay = { origin: [0, 0, 0.6], direction: [0, 0, 1] };
		expect(rayToView(DEFAULTS, "p3", "plane", away, UNIT)).toBeUndefined();
		expect(rayToView(DEFAULTS, "p2", "plumb", { origin: [0, 1, 0], direction: [0, -1, 0] }, UNIT)).toBeUndefined();
	});
});
