import { fromUp, placeVectors, rows } from "../../../plant/orientation";
import type { Mesh } from "../../../plant/plant";
import type { Berries, BerrySurfaces, Grown } from "../grown";

/** Texels of vertices side by side in one row of their texture. */
export const VERTICES_PER_ROW = 1024;

/**
 * The surface of every berry: its own where the procedure gave it one, else the shared berry at each sphere. Undefined
 * where only the skeleton was asked for.
 */
export function surfacesOf({ surfaces, berry, berries }: Grown): BerrySurfaces | undefined {
	return surfaces ?? (berry && placedEverywhere(berry, berries));
}

function placedEverywhere(berry: Mesh, { count, spheres, directions }: Berries): BerrySurfaces {
	const size = berry.positions.length;
	const positions = new Float32Array(size * count);
	const normals = new Float32Array(size * count);
	for (let i = 0; i < count; i++) {
		const [x, y, z, radius] = spheres.subarray(4 * i, 4 * i + 4);
		const turn = rows(fromUp(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]));
		placeVectors(berry.normals, turn, 1, [0, 0, 0], normals, i * size);
		placeVectors(berry.positions, turn, radius, [x, y, z], positions, i * size);
	}
	return { uvs: berry.uvs, indices: berry.indices, positions, normals, pressed: new Uint8Array((size / 3) * count) };
}

/**
 * Packs vertices into texels of four words: the bits of x, y, z; then, from the lowest, 8 bits of `pressed` and two
 * times 12 of the normal's octahedral map (Cigolle et al. 2014, "A survey of efficient representations for independent
 * unit vectors"). The vertex shader is packed_vertex() of berry_shader.ts.
 * @param words at least 4 × vertices
 */
export function packVertices({ positions, normals, pressed }: BerrySurfaces, words: Uint32Array): void {
	const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
	for (let i = 0, v = 0; i < pressed.length; i++, v += 3) {
		const at = 4 * i;
		floats[at] = positions[v];
		floats[at + 1] = positions[v + 1];
		floats[at + 2] = positions[v + 2];
		words[at + 3] = pressed[i] | packNormal(normals[v], normals[v + 1], normals[v + 2]);
	}
}

const STEPS = 4095;

/** A unit vector as two times 12 bits, above the lowest 8. */
function packNormal(x: number, y: number, z: number): number {
	const sum = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
	let u = x / sum;
	let v = y / sum;
	if (z < 0) {
		const folded = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
		v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
		u = folded;
	}
	const first = Math.round((0.5 + 0.5 * u) * STEPS);
	const second = Math.round((0.5 + 0.5 * v) * STEPS);
	return ((second << 20) | (first << 8)) >>> 0;
}
