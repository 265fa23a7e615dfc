/** Boxes in which nothing grows, as parts: what a plant has grown around belongs to its picture. */
import { linear } from "../../../plant/colour";
import type { Material } from "../../../plant/material";
import type { Part, PartMesh } from "../../../plant/part";
import type { Bounded } from "./bounded";
import { wallsOf } from "./editor/walls";

const STONE: Material = { name: "Obstacle", colour: linear("b9b2a6"), roughness: 0.95 };

export function* obstacleParts(specimen: Bounded): Generator<Part> {
	for (const [i, wall] of wallsOf(specimen).entries()) {
		yield { name: `Obstacle ${i + 1}`, shape: { mesh: boxMesh(wall), material: STONE } };
	}
}

/** Six faces of four corners each: low x, y, z, high x, y, z. */
function boxMesh(corners: readonly number[]): PartMesh {
	const positions: number[] = [];
	const normals: number[] = [];
	const indices: number[] = [];
	for (let face = 0; face < 6; face++) {
		const [axis, side] = [face % 3, face < 3 ? 0 : 1];
		const [across, along] = [(axis + 1) % 3, (axis + 2) % 3];
		const first = positions.length / 3;
		for (const [u, v] of [
			[0, 0],
			[1, 0],
			[1, 1],
			[0, 1],
		]) {
			const corner = [0, 0, 0];
			corner[axis] = corners[axis + 3 * side];
			corner[across] = corners[across + 3 * u];
			corner[along] = corners[along + 3 * v];
			positions.push(...corner);
			normals.push(...[0, 1, 2].map((k) => (k === axis ? 2 * side - 1 : 0)));
		}
		indices.push(...(side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]).map((k) => first + k));
	}
	return {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: new Float32Array((2 * positions.length) / 3),
		indices: Uint32Array.from(indices),
	};
}
