import { expect, it } from "vitest";
import { sparse } from "../../../web/src/formats/sparse";
import { type Part, TRANSFORM } from "../../../web/src/plant/part";
import { HAIR, tetrahedron } from "./toy_parts";

const COUNT = 1000;
const transforms = new Float32Array(TRANSFORM * COUNT);
for (let i = 0; i < COUNT; i++) transforms.set([i, 0, 0, 0, 0, 0, 1, 2], TRANSFORM * i);
const sky = Uint8Array.from({ length: COUNT }, (_, i) => i % 256);
const crown = (each?: (i: number) => { name: string }): Part => ({
	name: "Crown",
	shape: {
		mesh: tetrahedron([0, 0, 0], 1),
		material: HAIR,
		instances: { transforms, sky, ...(each ? { each } : {}) },
	},
});

it("keeps as much area of a crown in fewer leaves, from all over it, each in its own shade", () => {
	const [{ shape }] = sparse([crown()], 1000);
	const { transforms: stored, sky: shades } = shape?.instances ?? { transforms: new Float32Array(0) };
	const count = stored.length / TRANSFORM;
	expect(count).toBe(150);
	let area = 0;
	for (let i = 0; i < count; i++) {
		area += stored[TRANSFORM * i + 7] ** 2;
		expect(shades?.[i]).toBe(stored[TRANSFORM * i] % 256);
	}
	expect(area).toBeCloseTo(4 * COUNT, 0);
	const places = Array.from({ length: count }, (_, i) => stored[TRANSFORM * i]);
	expect(Math.max(...places.slice(1).map((x, i) => x - places[i]))).toBeLessThan(8);
	expect([places[0] < 7, (places.at(-1) ?? 0) > COUNT - 8]).toEqual([true, true]);
});

it("leaves alone what the budget has room for, and what is a part by itself", () => {
	const few = [crown()];
	expect(sparse(few, 100_000)).toEqual(few);
	const named = [crown((i) => ({ name: `Leaf ${i}` }))];
	expect(sparse(named, 100)[0].shape?.instances?.transforms).toBe(transforms);
});
