import { expect, it } from "vitest";
import { EDGE_NORMAL_SIZE, edgeNormalsOf } from "../../../../web/src/models/stand/render/edge_normals";
import { PLACE_STEPS } from "../../../../web/src/plant/packed_mesh";

const at = (edgeNormals: Int8Array, vertex: number) => [
	...edgeNormals.subarray(EDGE_NORMAL_SIZE * vertex, EDGE_NORMAL_SIZE * vertex + 3),
];
const width = (edgeNormals: Int8Array, vertex: number) =>
	PLACE_STEPS * (edgeNormals[EDGE_NORMAL_SIZE * vertex + 3] / 127) ** 2;

it("a stem is widened outwards, not lengthened, by the width of its sides", () => {
	const round = [0, 1, 2, 3].map((k) => [
		Math.round(300 * Math.cos(1.5708 * k)),
		Math.round(300 * Math.sin(1.5708 * k)),
	]);
	const positions = Int16Array.from([0, 9000, 30_000].flatMap((y) => round.flatMap(([x, z]) => [x, y, z])));
	const indices: number[] = [];
	for (const low of [0, 4])
		for (let k = 0; k < 4; k++) {
			const [a, b] = [low + k, low + ((k + 1) % 4)];
			indices.push(a, b, b + 4, a, b + 4, a + 4);
		}
	const edgeNormals = edgeNormalsOf({ positions, indices: Uint16Array.from(indices) });
	for (let v = 0; v < 12; v++) {
		const [x, y, z] = at(edgeNormals, v);
		const [out, across] = [round[v % 4][0] / 300, round[v % 4][1] / 300];
		expect(x * out + z * across).toBeGreaterThan(0.7 * 127);
		expect(Math.abs(y)).toBeLessThan(4);
		expect(width(edgeNormals, v)).toBeGreaterThan(424);
		expect(width(edgeNormals, v)).toBeLessThan(520);
	}
});

it("an open blade is widened across its margins", () => {
	const positions = Int16Array.of(0, 0, 0, 500, 9000, 0, 0, 20_000, 0, -500, 9000, 0);
	const edgeNormals = edgeNormalsOf({ positions, indices: Uint16Array.of(0, 1, 2, 0, 2, 3) });
	expect(at(edgeNormals, 1)[0]).toBeGreaterThan(120);
	expect(at(edgeNormals, 3)[0]).toBeLessThan(-120);
});

it("a degenerate mesh is not moved", () => {
	expect([...edgeNormalsOf({ positions: new Int16Array(9), indices: Uint16Array.of(0, 1, 2) })]).toEqual(
		Array(12).fill(0),
	);
});

it("is computed once per mesh", () => {
	const mesh = { positions: Int16Array.of(0, 0, 0, 500, 9000, 0, 0, 20_000, 0), indices: Uint16Array.of(0, 1, 2) };
	const edgeNormals = edgeNormalsOf(mesh);
	expect(edgeNormalsOf(mesh)).toBe(edgeNormals);
	const other = edgeNormalsOf({ ...mesh, indices: Uint16Array.of(0, 2, 1) });
	expect(other).not.toBe(edgeNormals);
	expect(other).toEqual(edgeNormals);
});
