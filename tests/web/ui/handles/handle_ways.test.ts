import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { placeUnder, visibleWays } from "../../../../web/src/ui/handles/handle_ways";
import type { HandleVector } from "../../../../web/src/ui/handles/plant_handle";
import { evenly } from "../../evenly";

const X: HandleVector = [1, 0, 0];
const Y: HandleVector = [0, 1, 0];
const place = fc.tuple(evenly(-1, 1), evenly(-1, 1), evenly(-1, 1));

describe("a dragged handle", () => {
	it("does not move while the pointer is on it, on a plane and on a line", () =>
		fc.assert(
			fc.property(place, place, fc.constantFrom([X, Y], [Y]), (at, offset, ways) => {
				const eye: HandleVector = [offset[0], offset[1], 3];
				const direction: HandleVector = [at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]];
				const found = placeUnder(at, ways, { origin: eye, direction }) as HandleVector;
				for (const k of [0, 1, 2]) expect(found[k]).toBeCloseTo(at[k], 6);
			}),
		));

	it("moves to the intersection of the ray with its plane, within limits", () => {
		const ray = { origin: [0.25, -0.5, 2], direction: [0, 0, -4] } as const;
		expect(placeUnder([0, 0, 0.5], [X, Y], ray)).toEqual([0.25, -0.5, 0.5]);
		expect(placeUnder([0, 0, 0.5], [Y], ray)).toEqual([0, -0.5, 0.5]);
	});

	it("does not move by a ray along its plane or line, or with the handle behind the eye", () => {
		expect(placeUnder([0, 0, 0], [X, Y], { origin: [0, 0, 1], direction: [1, 0, 0] })).toBeUndefined();
		expect(placeUnder([0, 0, 0], [X, Y], { origin: [0, 0, 1], direction: [0, 0, 1] })).toBeUndefined();
		expect(placeUnder([0, 0, 0], [Y], { origin: [0, 3, 0.01], direction: [0, -1, 0] })).toBeUndefined();
		expect(placeUnder([0, 0, 0], [Y], { origin: [0, 0, 1], direction: [0, 0, 1] })).toBeUndefined();
	});

	it("moves along the visible direction only if its plane is seen edge-on", () => {
		const from = (direction: HandleVector) => visibleWays([X, Y], { origin: [0, 0, 0], direction });
		expect(from([0, 0, -1])).toEqual([X, Y]);
		expect(from([0.5, 0.5, -1])).toEqual([X, Y]);
		expect(from([1, 0, -0.1])).toEqual([Y]);
		expect(from([0.1, -3, 0.1])).toEqual([X]);
	});
});
