import { describe, expect, it } from "vitest";
import { receiversOf } from "../../../../../web/src/models/bunch/render/receivers";
import { pressedBunch } from "../pressed_bunch";
import { sampleBunch } from "../sample_bunch";

describe("receiversOf", () => {
	it("has each berry about its centre, as far as it reaches", () => {
		const bunch = pressedBunch({ count: 8, elongation: 1.5 });
		const { bodies, count } = receiversOf(bunch);
		expect(count).toBe(8 + bunch.internodes.count);
		const [, length] = bunch.berries.traits;
		for (let i = 0; i < 8; i++) {
			expect([...bodies.subarray(4 * i, 4 * i + 3)]).toEqual([...bunch.berries.spheres.subarray(4 * i, 4 * i + 3)]);
		}
		expect(bodies[3]).toBeCloseTo(length / 2, 7);
	});

	it("has each internode about its middle, as far as its ends", () => {
		const bunch = sampleBunch(40);
		const { bodies } = receiversOf(bunch);
		const { ends, count } = bunch.internodes;
		for (let i = 0; i < count; i++) {
			const at = 4 * (40 + i);
			const [from, to] = [0, 3].map((k) => ends.subarray(6 * i + k, 6 * i + k + 3));
			for (let k = 0; k < 3; k++) expect(bodies[at + k]).toBeCloseTo((from[k] + to[k]) / 2, 6);
			expect(bodies[at + 3]).toBeCloseTo(Math.hypot(...from.map((value, k) => to[k] - value)) / 2, 6);
		}
	});

	it.each([
		[1, 1],
		[1.34, 1],
		[1.5, 2],
		[2.5, 3],
	])("represents a berry %f times as long as wide by %i spheres, along its length", (elongation, spheres) => {
		const bunch = pressedBunch({ count: 1, elongation });
		const { owner, index } = receiversOf(bunch);
		expect([...owner]).toEqual(new Array(spheres).fill(0));
		const [width, length] = bunch.berries.traits;
		for (let i = 0; i < spheres; i++) {
			const away = [0, 1, 2].map((k) => index.spheres[4 * i + k] - bunch.berries.spheres[k]);
			const along = away.reduce((sum, value, k) => sum + value * bunch.berries.directions[k], 0);
			// On the axis, and within the berry.
			expect(Math.hypot(...away)).toBeCloseTo(Math.abs(along), 7);
			expect(Math.abs(along) + index.spheres[4 * i + 3]).toBeLessThanOrEqual(Math.max(length, width) / 2 + 1e-6);
		}
		const owners = [...receiversOf(pressedBunch({ count: 3, elongation })).owner];
		expect(owners).toEqual([0, 1, 2].flatMap((berry) => new Array(spheres).fill(berry)));
		if (spheres > 1) expect(Math.max(...index.spheres.subarray(3, 4))).toBeCloseTo(0.48 * width, 7);
	});
});
