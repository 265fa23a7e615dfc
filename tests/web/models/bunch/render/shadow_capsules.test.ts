import { describe, expect, it } from "vitest";
import { leafDiscs } from "../../../../../web/src/models/bunch/render/leaf_discs";
import { capsulesOf } from "../../../../../web/src/models/bunch/render/shadow_capsules";
import { pressedBunch } from "../pressed_bunch";
import { sampleBunch } from "../sample_bunch";

const square = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
const part = { firstIndex: 0, indexCount: 0, vertexCount: 4 };
const foliage = {
	positions: Float32Array.from([...square, ...square.map((value) => value + 3)]),
	normals: new Float32Array(24),
	uvs: new Float32Array(16),
	indices: new Uint32Array(0),
	parts: [
		{ ...part, kind: "cane" as const, firstVertex: 0 },
		{ ...part, kind: "leaf" as const, firstVertex: 4 },
	],
};

describe("leafDiscs", () => {
	it("places discs over each leaf, within its extent, and none over the cane", () => {
		const discs = leafDiscs(foliage);
		expect(discs).toHaveLength(4 * 4);
		expect(discs[0]).toBe(3);
		expect(discs[3]).toBeGreaterThan(0);
		expect(discs[3]).toBeLessThan(0.5);
	});
});

describe("capsulesOf", () => {
	const bunch = sampleBunch(40);
	const seen = [...bunch.internodes.kind].filter((kind) => kind < 2).length;

	it("casts berries, and of the stems among them those that show", () => {
		const { count, begins, ends } = capsulesOf(bunch, true);
		expect(count).toBe(bunch.berries.count + seen);
		expect(begins).toHaveLength(4 * count);
		expect(ends).toHaveLength(3 * count);
		// A round berry is a ball of its radius.
		expect([...begins.subarray(0, 4)]).toEqual([...bunch.berries.spheres.subarray(0, 4)]);
		expect([...ends.subarray(0, 3)]).toEqual([...begins.subarray(0, 3)]);
	});

	it("casts every stem where there are no berries, from its start to its end", () => {
		const { count, begins, ends } = capsulesOf(bunch, false);
		expect(count).toBe(bunch.internodes.count);
		const last = count - 1;
		expect([...begins.subarray(4 * last, 4 * last + 3)]).toEqual([
			...bunch.internodes.ends.subarray(6 * last, 6 * last + 3),
		]);
		expect([...ends.subarray(3 * last)]).toEqual([...bunch.internodes.ends.subarray(6 * last + 3)]);
		expect(begins[4 * last + 3]).toBeCloseTo(bunch.internodes.radii[2 * last], 7);
	});

	it("stretches long berries along their axis", () => {
		const long = pressedBunch({ count: 1, elongation: 2 });
		const { begins, ends } = capsulesOf(long, true);
		const [width, length] = long.berries.traits;
		const run = Math.hypot(...[0, 1, 2].map((k) => ends[k] - begins[k]));
		expect(run + 2 * begins[3]).toBeCloseTo(length, 6);
		expect(begins[3]).toBeCloseTo(width / 2, 7);
	});

	it("casts leaves in either case, after all else", () => {
		for (const whole of [true, false]) {
			const { count, begins, ends } = capsulesOf({ ...bunch, foliage }, whole);
			expect(count).toBe(capsulesOf(bunch, whole).count + 4);
			expect([...ends.subarray(3 * (count - 1))]).toEqual([3, 4, 3]);
			expect(begins[4 * count - 1]).toBeGreaterThan(0);
		}
	});
});
