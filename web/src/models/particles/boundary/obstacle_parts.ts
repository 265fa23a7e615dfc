/** Obstacles as parts of the plant, so that pictures and files show them. */
import { linear } from "../../../plant/colour";
import type { Material } from "../../../plant/material";
import type { Part, PartMesh } from "../../../plant/part";
import type { Bounded } from "./bounded";
import { wallsOf } from "./editor/walls";

const STONE: Material = { name: "Obstacle", colour: linear("b9b2a6"), roughness: 0.95, still: true };
/** Segments around and rings of an ellipsoid. */
const [ROUND, RINGS] = [32, 16];

/** Yields each obstacle as a part: boxes, then ellipsoids. */
export function* obstacleParts(specimen: Bounded): Generator<Part> {
	for (const [i, wall] of wallsOf(specimen).entries()) {
		yield { name: `Obstacle ${i + 1}`, shape: { mesh: boxMesh(wall), material: STONE } };
	}
	for (const [i, round] of wallsOf(specimen, "rounds").entries()) {
		yield { name: `Round obstacle ${i + 1}`, shape: { mesh: ellipsoidMesh(round), material: STONE } };
	}
}

/**
 * Returns the ellipsoid inscribed in a box, with rings from its lowest to its highest point.
 * @param corners low x, y, z, high x, y, z
 */
function ellipsoidMesh(corners: readonly number[]): PartMesh {
	const middle = [0, 1, 2].map((k) => (corners[k] + corners[k + 3]) / 2);
	const half = [0, 1, 2].map((k) => Math.max((corners[k + 3] - corners[k]) / 2, 1e-6));
	const across = ROUND + 1;
	const count = (RINGS + 1) * across;
	const [positions, normals] = [new Float32Array(3 * count), new Float32Array(3 * count)];
	const uvs = new Float32Array(2 * count);
	const indices: number[] = [];
	for (let ring = 0; ring <= RINGS; ring++) {
		const up = -Math.cos((Math.PI * ring) / RINGS);
		const out = Math.sin((Math.PI * ring) / RINGS);
		for (let k = 0; k < across; k++) {
			const vertex = ring * across + k;
			const angle = (2 * Math.PI * k) / ROUND;
			const unit = [out * Math.cos(angle), up, -out * Math.sin(angle)];
			const normal = unit.map((value, axis) => value / half[axis]);
			const length = Math.hypot(...normal);
			positions.set(
				unit.map((value, axis) => middle[axis] + half[axis] * value),
				3 * vertex,
			);
			normals.set(
				normal.map((value) => value / length),
				3 * vertex,
			);
			uvs.set([k / ROUND, 1 - ring / RINGS], 2 * vertex);
			if (ring === RINGS || k === ROUND) continue;
			// At the poles one of the two triangles has no area.
			if (ring > 0) indices.push(vertex, vertex + 1, vertex + across + 1);
			if (ring < RINGS - 1) indices.push(vertex, vertex + across + 1, vertex + across);
		}
	}
	return { positions, normals, uvs, indices: Uint32Array.from(indices) };
}

/**
 * Returns the mesh of a box.
 * @param corners low x, y, z, high x, y, z
 */
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
		// Counter-clockwise, seen from outside.
		indices.push(...(side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]).map((k) => first + k));
	}
	return {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: new Float32Array((2 * positions.length) / 3),
		indices: Uint32Array.from(indices),
	};
}
