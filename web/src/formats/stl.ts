/** Binary STL for printers: one closed body, millimetres, +Z up. */

import type { Part } from "../plant/part";
import type { About } from "./about";
import { GENERATOR } from "./generator";
import { type Solid, solidNotes, solidOf } from "./solid";

const HEADER = 80;
const TRIANGLE = 50;

/**
 * Makes the plant one solid body, enlarged or reduced for printing, and writes it.
 * @param thickness the least thickness, millimetres
 * @param note receives a sentence for each way in which the body differs from the request
 * @throws EmptyPlantError where the plant has no mesh
 */
export async function stl(
	parts: Iterable<Part>,
	about: About,
	thickness: number,
	note: (text: string) => void = () => {},
): Promise<Uint8Array<ArrayBuffer>> {
	const solid = await solidOf(parts, thickness / 1000);
	solidNotes(solid, thickness / 1000).forEach(note);
	const { indices } = solid;
	const corners = printed(solid);
	const file = new Uint8Array(HEADER + 4 + (TRIANGLE * indices.length) / 3);
	const words = new TextEncoder().encode(`${GENERATOR}: ${about.name}, mm, 1:${solid.scale}`);
	file.set(words.subarray(0, HEADER));
	const view = new DataView(file.buffer);
	view.setUint32(HEADER, indices.length / 3, true);
	for (let at = 0; at < indices.length; at += 3) {
		const offset = HEADER + 4 + (TRIANGLE * at) / 3;
		const [a, b, c] = [indices[at], indices[at + 1], indices[at + 2]].map((v) => corners.subarray(3 * v, 3 * v + 3));
		const normal = normalOf(a, b, c);
		for (const [i, value] of [...normal, ...a, ...b, ...c].entries()) view.setFloat32(offset + 4 * i, value, true);
	}
	return file;
}

/** Converts positions from metres and +Y up to millimetres and +Z up, as printers expect. */
export function printed({ positions }: Solid): Float32Array {
	const turned = new Float32Array(positions.length);
	for (let i = 0; i < positions.length; i += 3) {
		turned[i] = 1000 * positions[i];
		turned[i + 1] = -1000 * positions[i + 2];
		turned[i + 2] = 1000 * positions[i + 1];
	}
	return turned;
}

/** Returns the unit normal of a triangle whose corners are counter-clockwise; zero for a triangle without area. */
function normalOf(a: Float32Array, b: Float32Array, c: Float32Array): number[] {
	const [u, v] = [0, 1, 2]
		.map((k) => [b[k] - a[k], c[k] - a[k]])
		.reduce<number[][]>(
			([p, q], [s, t]) => [
				[...p, s],
				[...q, t],
			],
			[[], []],
		);
	const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
	const length = Math.hypot(...cross) || 1;
	return cross.map((value) => value / length);
}
