import { describe, expect, it } from "vitest";
import { together } from "../../../web/src/formats/together";
import type { Part, PartMesh, Shape } from "../../../web/src/plant/part";
import { HAIR, tetrahedron } from "./toy_parts";

/** Upright, a quarter turn about Y, and at rest but twice as large. */
const TRANSFORMS = [
	[1, 2, 3, 0, 0, 0, 1, 1],
	[0, 0, 0, 0, Math.SQRT1_2, 0, Math.SQRT1_2, 1],
	[0, 0, 0, 0, 0, 0, 1, 2],
];

function leaves(times: number, mesh: PartMesh = tetrahedron([0, 0, 0], 1)): Part {
	const transforms = Float32Array.from(Array.from({ length: times }, (_, i) => TRANSFORMS[i % 3]).flat());
	const sky = Uint8Array.from({ length: times }, (_, i) => 10 * (i % 3));
	return { name: "Leaves", extras: { of: "oak" }, shape: { mesh, material: HAIR, instances: { transforms, sky } } };
}

describe("instances that are no parts by themselves", () => {
	it("are one mesh, each where it stood, in the light that it had", () => {
		const { name, extras, shape, children } = together(leaves(3));
		expect([name, extras, children]).toEqual(["Leaves", { of: "oak" }, undefined]);
		expect(shape?.material).toBe(HAIR);
		expect(shape?.instances).toBeUndefined();
		const { positions, normals, uvs, indices, sky } = (shape as Shape).mesh;
		const corner = (vertex: number) =>
			[...positions.subarray(3 * vertex, 3 * vertex + 3)].map((value) => Number(value.toFixed(5)));
		// The tetrahedron's first two corners are (1, 1, 1) and (1, −1, −1).
		expect([corner(0), corner(1)]).toEqual([
			[2, 3, 4],
			[2, 1, 2],
		]);
		expect([corner(4), corner(5)]).toEqual([
			[1, 1, -1],
			[-1, -1, -1],
		]);
		expect(corner(8)).toEqual([2, 2, 2]);
		for (let vertex = 0; vertex < 12; vertex++) {
			expect(Math.hypot(...normals.subarray(3 * vertex, 3 * vertex + 3))).toBeCloseTo(1, 5);
		}
		expect([...uvs.subarray(8, 16)]).toEqual([...uvs.subarray(0, 8)]);
		expect([...indices.subarray(12, 15)]).toEqual([4, 5, 6]);
		expect([...(sky ?? [])]).toEqual([0, 0, 0, 0, 10, 10, 10, 10, 20, 20, 20, 20]);
	});

	it("are several meshes of like size where one would need longer numbers", () => {
		const { shape, children = [] } = together(leaves(20_000));
		expect(shape).toBeUndefined();
		expect(children.map(({ name }) => name)).toEqual(["Leaves 1", "Leaves 2"]);
		for (const child of children) {
			expect(child.shape?.mesh.positions).toHaveLength(3 * 4 * 10_000);
			expect(child.shape?.mesh.indices.reduce((most, index) => Math.max(most, index), 0)).toBe(39_999);
		}
	});

	it("stay what they are where each is a part, where there is one, and in what parts hold", () => {
		const own = leaves(3);
		const each = (i: number) => ({ name: `Leaf ${i}` });
		const named = { ...own, shape: { ...own.shape, instances: { ...own.shape?.instances, each } } } as Part;
		expect(together(named)).toEqual(named);
		expect(together(leaves(1)).shape?.instances).toBeDefined();
		const twig = together({ name: "Twig", children: [leaves(2)] });
		expect(twig.children?.[0].shape?.mesh.positions).toHaveLength(24);
	});
});
