import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { EmptyPlantError } from "../../../web/src/formats/file_error";
import { ply } from "../../../web/src/formats/ply";
import { solidNotes, solidOf, tornAt } from "../../../web/src/formats/solid";
import { stl } from "../../../web/src/formats/stl";
import { threeMf } from "../../../web/src/formats/three_mf";
import { emptyVoxels, fillInside, thicken, withoutPinches } from "../../../web/src/formats/voxels";
import type { Part, PartMesh } from "../../../web/src/plant/part";
import { ABOUT, HAIR, tetrahedron } from "./toy_parts";

/** A square sheet in the plane of x and z, its edge in metres. */
const sheet = (edge: number): PartMesh => ({
	positions: Float32Array.of(0, 0, 0, edge, 0, 0, edge, 0, edge, 0, 0, edge),
	normals: Float32Array.of(0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0),
	uvs: new Float32Array(8),
	indices: Uint32Array.of(0, 2, 1, 0, 3, 2),
});
const part = (mesh: PartMesh): Part => ({ name: "Part", shape: { mesh, material: HAIR } });
const ball = part(tetrahedron([0, 0, 0], 0.005));

/** Cubic metres; positive where triangles go counter-clockwise seen from outside. */
function volumeOf(positions: Float32Array, indices: Uint32Array): number {
	let sum = 0;
	for (let i = 0; i < indices.length; i += 3) {
		const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * indices[i + k], 3 * indices[i + k] + 3));
		sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
	}
	return sum / 6;
}

/** Into how many parts, without a vertex in common, the triangles fall. */
function shellsOf(indices: Uint32Array): number {
	const parents = new Map<number, number>();
	const root = (vertex: number): number => {
		const parent = parents.get(vertex) ?? vertex;
		if (parent === vertex) return vertex;
		const found = root(parent);
		parents.set(vertex, found);
		return found;
	};
	for (let i = 0; i < indices.length; i += 3) {
		for (const k of [1, 2]) parents.set(root(indices[i]), root(indices[i + k]));
		parents.set(root(indices[i]), root(indices[i]));
	}
	return [...parents].filter(([vertex, parent]) => vertex === parent).length;
}

function extentOf(positions: Float32Array, axis: number): number {
	const values = positions.filter((_, i) => i % 3 === axis);
	return Math.max(...values) - Math.min(...values);
}

describe("a body for printers", () => {
	it("is closed, as large as what it is made of, and faces outwards", async () => {
		const { positions, indices, scale, thickness } = await solidOf([ball], 0.0005);
		expect([tornAt(indices).size, scale]).toEqual([0, 1]);
		expect(thickness).toBeCloseTo(0.0005, 6);
		// A tetrahedron between corners of a cube of 10 mm takes a third of it; its tips are rounded off.
		expect(volumeOf(positions, indices) / (1e-6 / 3)).toBeGreaterThan(0.9);
		expect(volumeOf(positions, indices) / (1e-6 / 3)).toBeLessThan(1.1);
	});

	it("is told from one that has a hole, or three faces at an edge", () => {
		const { indices } = tetrahedron([0, 0, 0], 1);
		expect(tornAt(indices).size).toBe(0);
		expect([...tornAt(indices.slice(3))].sort()).toEqual([0, 1, 2]);
		expect([...tornAt(Uint32Array.of(...indices, 0, 1, 2))].sort()).toEqual([0, 1, 2]);
	});

	it("gives a sheet the least thickness, and what is thin the same", async () => {
		for (const least of [0.001, 0.002]) {
			const { positions, indices, thickness } = await solidOf([part(sheet(0.02))], least);
			expect(tornAt(indices).size).toBe(0);
			expect(thickness).toBeCloseTo(least, 6);
			expect(extentOf(positions, 1)).toBeGreaterThanOrEqual(0.99 * least);
			expect(extentOf(positions, 1)).toBeLessThan(2.1 * least);
			expect(volumeOf(positions, indices)).toBeGreaterThan(0.9 * 0.02 ** 2 * least);
		}
	});

	it("is one where parts meet, and of a scale that fits a bed", async () => {
		const both = [ball, part(tetrahedron([0.002, 0, 0], 0.005))];
		const { positions, indices } = await solidOf(both, 0.0005);
		expect(tornAt(indices).size).toBe(0);
		expect(extentOf(positions, 0)).toBeGreaterThan(0.0105);
		const tree = await solidOf([part(tetrahedron([0, 3, 0], 3))], 0.002);
		expect(tree.scale).toBe(50);
		expect(extentOf(tree.positions, 1)).toBeCloseTo(6 / 50, 2);
	});

	it("has no hollows, where closed meshes leave some between them", async () => {
		// A box of six sheets that meet: closed, but by no mesh.
		const face = (axis: number, at: number): Part => {
			const corners = [0, 0, 1, 0, 1, 1, 0, 1].map((value) => value * 0.02);
			const positions = new Float32Array(12);
			for (let k = 0; k < 4; k++) {
				positions[3 * k + axis] = at;
				positions[3 * k + ((axis + 1) % 3)] = corners[2 * k];
				positions[3 * k + ((axis + 2) % 3)] = corners[2 * k + 1];
			}
			return part({ ...sheet(1), positions });
		};
		const box = [0, 1, 2].flatMap((axis) => [face(axis, 0), face(axis, 0.02)]);
		const { positions, indices, loose } = await solidOf(box, 0.001);
		expect([shellsOf(indices), loose]).toEqual([1, 0]);
		expect(volumeOf(positions, indices)).toBeGreaterThan(0.98 * 0.02 ** 3);
	});

	it("joins pieces that are near each other, and leaves out those that are not", async () => {
		const apart = (distance: number) => solidOf([ball, part(tetrahedron([distance, 0, 0], 0.004))], 0.0005);
		const joined = await apart(0.012);
		expect([shellsOf(joined.indices), joined.loose, tornAt(joined.indices).size]).toEqual([1, 0, 0]);
		expect(extentOf(joined.positions, 0)).toBeGreaterThan(0.0205);
		const far = await apart(0.03);
		expect([shellsOf(far.indices), far.loose]).toEqual([1, 1]);
		expect(extentOf(far.positions, 0)).toBeLessThan(0.0105);
		expect(solidNotes(far, 0.0005)).toEqual([expect.stringMatching(/^1 loose piece was left out/)]);
	});

	it("says where it is thicker than was asked for", async () => {
		expect(solidNotes({ thickness: 0.0012, loose: 0 }, 0.0002)).toEqual([
			expect.stringMatching(/^The minimum thickness is 1\.2 mm, .* as thin as 0\.2 mm\.$/),
		]);
		expect(solidNotes(await solidOf([ball], 0.001), 0.001)).toEqual([]);
	});

	it("cannot be made of an empty plant, which is an error of its own", async () => {
		await expect(solidOf([], 0.001)).rejects.toThrow(EmptyPlantError);
		await expect(threeMf([{ name: "Nothing" }], ABOUT, 1)).rejects.toThrow(EmptyPlantError);
		await expect(stl([], ABOUT, 1)).rejects.toThrow(EmptyPlantError);
	});

	it("is the same in STL and in 3MF, in millimetres with +Z up", async () => {
		const tall = part({ ...sheet(0.02), positions: Float32Array.of(0, 0, 0, 0.02, 0, 0, 0.02, 0.04, 0, 0, 0.04, 0) });
		const file = await stl([tall], ABOUT, 1);
		const view = new DataView(file.buffer);
		const count = view.getUint32(80, true);
		expect([count > 0, file.length]).toEqual([true, 84 + 50 * count]);
		const heights = Array.from({ length: 3 * count }, (_, i) =>
			view.getFloat32(84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3) + 8, true),
		);
		expect(Math.max(...heights)).toBeGreaterThan(40);
		expect(Math.max(...heights)).toBeLessThan(42);
		const model = strFromU8(unzipSync(await threeMf([tall], ABOUT, 1))["3D/3dmodel.model"]);
		expect(model.match(/<triangle /g)).toHaveLength(count);
		expect(model).toContain('unit="millimeter"');
		const zs = [...model.matchAll(/z="([-\d.]+)"/g)].map(([, z]) => Number(z));
		expect(Math.max(...zs)).toBeCloseTo(Math.max(...heights), 2);
	});
});

describe("voxels", () => {
	it("fill what closed meshes hold, once where they overlap", () => {
		const voxels = emptyVoxels([-1, -1, -1], [1, 1, 1], 0.1);
		fillInside(voxels, [tetrahedron([0, 0, 0], 1), tetrahedron([0, 0, 0], 0.5)]);
		const filled = voxels.cells.reduce((sum, cell) => sum + cell, 0);
		expect(filled * 0.1 ** 3).toBeGreaterThan(0.95 * (8 / 3));
		expect(filled * 0.1 ** 3).toBeLessThan(1.05 * (8 / 3));
	});

	it("grow where they are thin, and only there", () => {
		const thick = { ...emptyVoxels([0, 0, 0], [2, 2, 2], 1) };
		const [nx, ny] = thick.size;
		const at = (x: number, y: number, z: number) => (z * ny + y) * nx + x;
		for (const [x, y, z] of [
			[5, 5, 5],
			[6, 5, 5],
			[5, 6, 5],
			[6, 6, 5],
		]) {
			thick.cells[at(x, y, z)] = 1;
			thick.cells[at(x, y, z + 1)] = 1;
		}
		const before = thick.cells.slice();
		thicken(thick, 2);
		expect(thick.cells).toEqual(before);
		thick.cells[at(2, 2, 2)] = 1;
		thicken(thick, 2);
		expect(thick.cells.reduce((sum, cell) => sum + cell, 0)).toBe(16);
	});

	it("lose pinches, where edges would meet four faces", () => {
		const voxels = emptyVoxels([0, 0, 0], [2, 2, 2], 1);
		const [nx] = voxels.size;
		const first = Math.floor(voxels.cells.length / 2);
		voxels.cells[first] = 1;
		voxels.cells[first + nx + 1] = 1;
		withoutPinches(voxels);
		expect(voxels.cells.reduce((sum, cell) => sum + cell, 0)).toBe(3);
	});
});

describe("points", () => {
	it("lie evenly on the surface, with its normals and colours", () => {
		const red = { ...sheet(1), colours: Float32Array.of(1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0) };
		const file = ply([part(red)], ABOUT, 4000);
		const text = new TextDecoder().decode(file.subarray(0, 600));
		const start = text.indexOf("end_header\n") + "end_header\n".length;
		expect(text).toContain("element vertex 4000");
		expect(file).toHaveLength(start + 33 * 4000);
		const view = new DataView(file.buffer, start);
		const quarters = [0, 0, 0, 0];
		for (let i = 0; i < 4000; i++) {
			const [x, y, z] = [0, 4, 8].map((offset) => view.getFloat32(33 * i + offset, true));
			expect(y).toBe(0);
			quarters[2 * Number(x > 0.5) + Number(z > 0.5)]++;
		}
		for (const quarter of quarters) expect(Math.abs(quarter - 1000)).toBeLessThan(40);
		expect([12, 16, 20].map((offset) => view.getFloat32(offset, true))).toEqual([0, 1, 0]);
		expect([24, 25, 26].map((offset) => view.getUint8(offset))).toEqual([255, 0, 0]);
	});
});
