import { Euler, Matrix4, Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { extentsOf } from "../../../../web/src/app/view/extents";
import type { Part } from "../../../../web/src/plant/part";

const material = { name: "Wood", colour: [0.5, 0.5, 0.5] as const, roughness: 1 };

function part(positions: number[], transforms?: Float32Array): Part {
	const mesh = {
		positions: Float32Array.from(positions),
		normals: new Float32Array(positions.length),
		uvs: new Float32Array((2 * positions.length) / 3),
		indices: new Uint32Array(0),
	};
	return { name: "Part", shape: { mesh, material, ...(transforms ? { instances: { transforms } } : {}) } } as Part;
}

describe("extentsOf", () => {
	it("returns the size of the box around all points of all parts, children included", () => {
		const child = part([-1, 0, 0.5]);
		const parts = [{ ...part([0, 0, 0, 2, 1, 0]), children: [child] }, part([0, -3, 0])];
		expect(extentsOf(parts)).toEqual({ width: 3, height: 4, depth: 0.5 });
	});

	it("places each instance by its position, rotation and scale", () => {
		const points = [0.1, 0.02, -0.3, -0.2, 0.4, 0.15, 0.05, -0.1, 0.3];
		const expected = {
			low: new Vector3(Infinity, Infinity, Infinity),
			high: new Vector3(-Infinity, -Infinity, -Infinity),
		};
		const transforms = new Float32Array(8 * 200);
		for (let i = 0; i < 200; i++) {
			const at = new Vector3(Math.sin(i), Math.cos(2 * i), Math.sin(3 * i));
			const rotation = new Quaternion().setFromEuler(new Euler(i, 2 * i, 3 * i));
			const scale = 0.5 + (i % 3);
			transforms.set([...at.toArray(), ...rotation.toArray(), scale], 8 * i);
			const matrix = new Matrix4().compose(at, rotation, new Vector3(scale, scale, scale));
			for (let k = 0; k < points.length; k += 3) {
				const point = new Vector3().fromArray(points, k).applyMatrix4(matrix);
				expected.low.min(point);
				expected.high.max(point);
			}
		}
		const size = expected.high.sub(expected.low);
		const found = extentsOf([part(points, transforms)]);
		expect(found?.width).toBeCloseTo(size.x, 5);
		expect(found?.height).toBeCloseTo(size.y, 5);
		expect(found?.depth).toBeCloseTo(size.z, 5);
	});

	it("returns nothing for a plant without points", () => {
		expect(extentsOf([{ name: "Group" }])).toBeUndefined();
	});
});
