import { expect, it } from "vitest";
import { isClosed, withoutHidden } from "../../../web/src/formats/hidden";
import type { Piece } from "../../../web/src/formats/piece";
import { HAIR } from "./toy_parts";

/** A box with corners of its own on every face. */
function box(low: readonly number[], high: readonly number[]): Piece {
	const [positions, normals, indices]: number[][] = [[], [], []];
	for (const axis of [0, 1, 2]) {
		for (const side of [0, 1]) {
			const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
			const first = positions.length / 3;
			for (const [a, b] of [
				[0, 0],
				[1, 0],
				[1, 1],
				[0, 1],
			]) {
				const corner = [0, 0, 0];
				corner[axis] = side ? high[axis] : low[axis];
				corner[u] = a ? high[u] : low[u];
				corner[v] = b ? high[v] : low[v];
				positions.push(...corner);
				normals.push(...[0, 1, 2].map((k) => (k === axis ? 2 * side - 1 : 0)));
			}
			const turn = side ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
			indices.push(...turn.map((corner) => first + corner));
		}
	}
	const mesh = {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: new Float32Array(0),
		indices: Uint32Array.from(indices),
	};
	return { material: HAIR, mesh };
}

const triangles = (pieces: readonly Piece[]) => pieces.map(({ mesh }) => mesh.indices.length / 3);
const big = box([-1, -1, -1], [1, 1, 1]);

it("takes away what lies inside a closed mesh, and keeps what comes out of it", () => {
	const inner = box([-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]);
	const rod = box([-0.1, -0.1, -0.1], [0.1, 2, 0.1]);
	// The rod's foot is gone; its walls come out, however much of them is inside.
	expect(triangles(withoutHidden([big, inner, rod], 0.001))).toEqual([12, 10]);
});

it("hides nothing behind what is open", () => {
	const open = { ...big, mesh: { ...big.mesh, indices: big.mesh.indices.slice(6) } };
	expect([isClosed(big.mesh), isClosed(open.mesh)]).toEqual([true, false]);
	const inner = box([-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]);
	expect(triangles(withoutHidden([open, inner], 0.001))).toEqual([10, 12]);
});

it("takes away both faces where two press on each other, and neither where there is room between them", () => {
	const beside = (gap: number) => box([1 + gap, -1, -1], [3, 1, 1]);
	const small = box([1, -0.5, -0.5], [2, 0.5, 0.5]);
	// A smaller one hides its own face, and of the larger one nothing that reaches beyond it.
	expect(triangles(withoutHidden([big, small], 0.001))).toEqual([12, 10]);
	expect(triangles(withoutHidden([big, beside(0.01)], 0.001))).toEqual([12, 12]);
});

it("takes away what other parts of the same mesh hold", () => {
	const inner = box([-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]).mesh;
	const both = {
		...big.mesh,
		positions: Float32Array.of(...big.mesh.positions, ...inner.positions),
		normals: Float32Array.of(...big.mesh.normals, ...inner.normals),
		indices: Uint32Array.of(...big.mesh.indices, ...inner.indices.map((vertex) => vertex + 24)),
	};
	expect(triangles(withoutHidden([{ material: HAIR, mesh: both }], 0.001))).toEqual([12]);
});
