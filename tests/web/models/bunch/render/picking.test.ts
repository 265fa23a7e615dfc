import fc from "fast-check";
import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { pickBerry } from "../../../../../web/src/models/bunch/render/picking";
import type { SceneVector } from "../../../../../web/src/render/model_renderer";
import { evenly } from "../../../evenly";
import { pressedBunch } from "../pressed_bunch";

const bunch = pressedBunch({ count: 60, elongation: 1.4, swell: 1 });
const { berries } = bunch;
const centre = (i: number) => new Vector3().fromArray(berries.spheres, 4 * i);
const tuple = (v: Vector3): SceneVector => [v.x, v.y, v.z];

describe("pickBerry", () => {
	it("meets no berry where it looks past all of them or away", () => {
		expect(pickBerry(berries, { origin: [1, 0, 0], direction: [0, 1, 0] })).toBeUndefined();
		const eye = centre(0).add(new Vector3(1, 0, 0));
		expect(pickBerry(berries, { origin: tuple(eye), direction: [1, 0, 0] })).toBeUndefined();
	});

	it("meets the nearest of those on its way, however long the direction", () => {
		const angle = evenly(0, 2 * Math.PI);
		fc.assert(
			fc.property(fc.nat(berries.count - 1), angle, evenly(0.1, 9), (i, turn, stretch) => {
				const out = new Vector3(Math.cos(turn), 0.2, Math.sin(turn));
				const eye = centre(i).addScaledVector(out, 0.5);
				const direction = out.clone().multiplyScalar(-stretch);
				const picked = pickBerry(berries, { origin: tuple(eye), direction: tuple(direction) });
				expect(picked).toBeDefined();
				expect(centre(picked ?? 0).distanceTo(eye)).toBeLessThanOrEqual(centre(i).distanceTo(eye) + 1e-6);
			}),
		);
	});

	it("takes a long berry for the ellipsoid it is: hit near its tip, missed as far beside its waist", () => {
		const one = pressedBunch({ count: 1, elongation: 2.5, swell: 1 }).berries;
		const axis = new Vector3().fromArray(one.directions);
		const across = new Vector3(0.3, 0.2, 0.9).cross(axis).normalize();
		const view = axis.clone().cross(across);
		const tip = 0.47 * one.traits[1];
		const from = (at: Vector3) => tuple(at.add(new Vector3().fromArray(one.spheres)).addScaledVector(view, -1));
		expect(pickBerry(one, { origin: from(axis.clone().multiplyScalar(tip)), direction: tuple(view) })).toBe(0);
		expect(
			pickBerry(one, { origin: from(across.clone().multiplyScalar(tip)), direction: tuple(view) }),
		).toBeUndefined();
	});
});
