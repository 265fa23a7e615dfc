import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { SphereIndex } from "../../../web/src/render/sphere_index";
import { evenly } from "../evenly";

const coordinate = evenly(-0.2, 0.2);
const sphere = fc.tuple(coordinate, coordinate, coordinate, evenly(0.001, 0.02));

describe("SphereIndex", () => {
	it("finds every sphere within the distance once", () => {
		const distance = evenly(0, 0.5);
		fc.assert(
			fc.property(fc.array(sphere, { maxLength: 60 }), sphere, distance, (spheres, [x, y, z], reach) => {
				const index = new SphereIndex(Float32Array.from(spheres.flat()));
				const found = new Uint32Array(100);
				const near = [...found.subarray(0, index.near(x, y, z, reach, found))];
				expect(new Set(near).size).toBe(near.length);
				spheres.forEach(([sx, sy, sz], i) => {
					if (Math.hypot(sx - x, sy - y, sz - z) < reach * 0.999) expect(near).toContain(i);
				});
			}),
		);
	});

	it("leaves out distant spheres", () => {
		const far = Float32Array.from([0, 0, 0, 0.01, 0.5, 0, 0, 0.01]);
		const found = new Uint32Array(4);
		expect(new SphereIndex(far).near(0, 0, 0, 0.02, found)).toBe(1);
	});

	it("stops at the end of the scratch memory, and finds nothing in an empty bunch", () => {
		const heap = Float32Array.from(Array.from({ length: 50 }, () => [0, 0, 0, 0.01]).flat());
		expect(new SphereIndex(heap).near(0, 0, 0, 1, new Uint32Array(8))).toBe(8);
		const none = new SphereIndex(new Float32Array(0));
		expect(none.near(0, 0, 0, 1, new Uint32Array(8))).toBe(0);
		expect(none.reach).toBe(0);
	});
});
