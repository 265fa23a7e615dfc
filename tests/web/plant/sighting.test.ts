import { describe, expect, it } from "vitest";
import { type DrawnGeometry, drawnOf, trianglesOf } from "../../../web/src/plant/drawn";
import { castRay } from "../../../web/src/plant/sighting";
import { toyPlant } from "./toy_plant";

const line = (origin: number[], direction = [0, 0, -1]) => ({ origin, direction });

/** Two upright lines, 1 m and 2 m away, and a square before the second at the right. */
const drawn: DrawnGeometry = {
	ends: Float32Array.of(0, 0, -1, 0, 1, -1, 0, 0, -2, 0, 3, -2),
	radii: Float32Array.of(0.1, 0.1, 0.1, 0.02),
	organs: 2,
	surface: (organ) =>
		organ === 1
			? {
					positions: Float32Array.of(1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0),
					indices: [0, 1, 2, 0, 2, 3],
					transform: Float32Array.of(0, 0, -1.5, 0, 0, 0, 1, 1),
				}
			: undefined,
};

describe("what a line of sight meets", () => {
	it("is the nearest, segments as thick as they are", () => {
		expect(castRay(drawn, line([0, 0.5, 0]), 0)).toEqual({ segment: 0 });
		expect(castRay(drawn, line([0.05, 1.5, 0]), 0)).toEqual({ segment: 1 });
		expect(castRay(drawn, line([0.09, 2.9, 0]), 0)).toBeUndefined();
		expect(castRay(drawn, line([0, 0.5, -1.5]), 0)).toEqual({ segment: 1 });
	});

	it("may miss a thread by a little, the more the farther it is", () => {
		expect(castRay(drawn, line([0.09, 2.9, 0]), 0.04)).toEqual({ segment: 1 });
		expect(castRay(drawn, line([0.2, 0.5, 0]), 0.04)).toBeUndefined();
	});

	it("is nothing behind the eye", () => {
		expect(castRay(drawn, line([0, 0.5, 0], [0, 0, 1]), 0)).toBeUndefined();
	});

	it("is a surface where its triangles are, from both sides", () => {
		expect(castRay(drawn, line([1.5, 0.2, 0]), 0)).toEqual({ organ: 1 });
		expect(castRay(drawn, line([1.5, 0.2, -3], [0, 0, 2]), 0)).toEqual({ organ: 1 });
		expect(castRay(drawn, line([2.05, 0.2, 0]), 0)).toBeUndefined();
	});
});

describe("many organs of one mesh", () => {
	/** Squares in a row, turned by a right angle about z and half as large; an index is counted whenever it is read. */
	const positions = Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0);
	const counted = { reads: 0 };
	const indices = new Proxy([0, 1, 2, 0, 2, 3], {
		get: (all, key) => {
			if (key !== "length") counted.reads++;
			return Reflect.get(all, key);
		},
	});
	const at = (organ: number) => Float32Array.of(3 * organ, 7, -2, 0, 0, Math.SQRT1_2, Math.SQRT1_2, 0.5);
	const row: DrawnGeometry = {
		ends: new Float32Array(0),
		radii: new Float32Array(0),
		organs: 1000,
		surface: (organ) => ({ positions, indices, transform: at(organ) }),
	};

	it("are met each where it stands, up to its corners", () => {
		for (const organ of [0, 1, 500, 999]) {
			for (const [x, y] of [
				[0, 0],
				[0.49, 0.49],
				[-0.49, 0.49],
				[0.49, -0.49],
			])
				expect(castRay(row, line([3 * organ + x, 7 + y, 0]), 0)).toEqual({ organ });
			expect(castRay(row, line([3 * organ + 0.51, 7, 0]), 0)).toBeUndefined();
		}
	});

	it("have the triangles of those alone looked at that may be met", () => {
		const fresh = { ...row };
		counted.reads = 0;
		expect(castRay(fresh, line([3 * 20, 7.1, 0]), 0)).toEqual({ organ: 20 });
		// The mesh once, and the one that is met.
		expect(counted.reads).toBe(12);
	});
});

describe("what a plant has drawn", () => {
	it("has organs where they stand, turned and in their size", () => {
		const surface = {
			positions: Float32Array.of(1, 0, 0),
			indices: [0],
			transform: Float32Array.of(5, 6, 7, 0, 0, Math.SQRT1_2, Math.SQRT1_2, 2),
		};
		const [x, y, z] = trianglesOf(surface);
		expect([x, y, z].map((each) => Math.round(each * 1e5) / 1e5)).toEqual([5, 8, 7]);
	});

	it("has an organ's mesh, or the run of a mesh that it is", () => {
		const plant = toyPlant();
		const organ = plant.organs.mesh.findIndex((mesh) => mesh >= 0);
		const whole = drawnOf(plant);
		expect(whole.surface(organ)?.positions).toBe(plant.meshes[plant.organs.mesh[organ]].positions);
		const mesh = plant.meshes.find(({ runs }) => runs.length > 1);
		if (!mesh) throw new Error("No mesh with runs.");
		const apart = drawnOf(plant, { [mesh.name]: Uint32Array.of(77, 78) });
		expect(apart.surface(78)).toMatchObject({ positions: mesh.positions, run: mesh.runs[1] });
	});
});
