import { describe, expect, it } from "vitest";
import { tangentsOf } from "../../../web/src/formats/tangents";

/** A square in the plane of `right` and `up`, its picture upright: v runs down. */
function square(uvs: number[]) {
	return {
		positions: Float32Array.of(0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0),
		normals: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1),
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
	};
}

const each = (tangents: Float32Array) => Array.from({ length: 4 }, (_, i) => [...tangents.subarray(4 * i, 4 * i + 4)]);

describe("tangents", () => {
	it.each([
		["upright", [0, 1, 1, 1, 1, 0, 0, 0], [1, 0, 0, 1]],
		["turned by a quarter", [0, 0, 0, 1, 1, 1, 1, 0], [0, 1, 0, 1]],
		["mirrored", [1, 1, 0, 1, 0, 0, 1, 0], [-1, 0, 0, -1]],
	])("run along u, and normal × tangent times the sign against v: %s", (_, uvs, expected) => {
		expect(each(tangentsOf(square(uvs)))).toEqual([expected, expected, expected, expected]);
	});

	it("lie at right angles to normals, of unit length, where the texture says nothing too", () => {
		for (const uvs of [
			[0, 1, 1, 1, 1, 0, 0, 0],
			[0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5],
		]) {
			const mesh = square(uvs);
			const lean = [0.6, 0, 0.8, -1, 0, 0, 0, 0.6, 0.8, 0, -1, 0];
			mesh.normals.set(lean);
			each(tangentsOf(mesh)).forEach(([x, y, z, w], i) => {
				expect(Math.hypot(x, y, z)).toBeCloseTo(1, 6);
				expect(x * lean[3 * i] + y * lean[3 * i + 1] + z * lean[3 * i + 2]).toBeCloseTo(0, 6);
				expect(Math.abs(w)).toBe(1);
			});
		}
	});
});
