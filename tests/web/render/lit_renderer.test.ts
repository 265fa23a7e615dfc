import { InstancedMesh, Matrix4, type Mesh, type MeshBasicMaterial, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { DrawnGeometry } from "../../../web/src/plant/drawn";
import { LitRenderer } from "../../../web/src/render/lit_renderer";

const drawn: DrawnGeometry = {
	ends: Float32Array.of(0, 0, 0, 0, 2, 0, 0, 2, 0, 3, 2, 0),
	radii: Float32Array.of(0.2, 0.1, 0.01, 0.01),
	organs: 1,
	surface: () => ({ positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), indices: [0, 1, 2] }),
};

const parts = (renderer: LitRenderer) => renderer.object.children as Mesh[];

describe("what shines", () => {
	it("covers segments, wider than they are and never too thin, also behind other parts", () => {
		const renderer = new LitRenderer();
		renderer.show(drawn, [0, 1], [], 0.05, "#c25e00");
		const tubes = parts(renderer);
		expect(tubes).toHaveLength(2);
		expect(tubes.map(({ material }) => (material as MeshBasicMaterial).depthTest)).toEqual([true, false]);
		const [tube] = tubes as InstancedMesh[];
		const size = (index: number) => {
			const [matrix, scale] = [new Matrix4(), new Vector3()];
			tube.getMatrixAt(index, matrix);
			return scale
				.setFromMatrixScale(matrix)
				.toArray()
				.map((each) => Math.round(each * 1000) / 1000);
		};
		expect(size(0)).toEqual([0.25, 2, 0.25]);
		expect(size(1)).toEqual([0.05, 3, 0.05]);
		const matrix = new Matrix4();
		tube.getMatrixAt(1, matrix);
		const ends = [-0.5, 0.5].map((y) => new Vector3(0, y, 0).applyMatrix4(matrix).toArray().map(Math.round));
		expect(ends).toEqual([[0, 2, 0], [3, 2, 0]]); // biome-ignore format: an end each
	});

	it("covers organs, and is removed with them", () => {
		const renderer = new LitRenderer();
		renderer.show(drawn, [], [0], 0.05, "orange");
		const [sheet] = parts(renderer);
		expect(sheet).not.toBeInstanceOf(InstancedMesh);
		expect([...sheet.geometry.getAttribute("position").array]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
		renderer.show(drawn, [], [], 0.05, "orange");
		expect(parts(renderer)).toEqual([]);
	});

	it("is thinned out evenly above a limit", () => {
		const count = 50_000;
		const many = { ...drawn, ends: new Float32Array(6 * count), radii: new Float32Array(2 * count) };
		const renderer = new LitRenderer();
		renderer.show(many, [...new Uint32Array(count).keys()], [], 1, "orange");
		expect((parts(renderer)[0] as InstancedMesh).count).toBe(20_000);
	});
});
