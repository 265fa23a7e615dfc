import type { Berries, BerrySurfaces, Grown, Mesh } from "../models/bunch/grown";

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
		const turn = turnFromUp(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]);
		place(berry.normals, normals, i * size, turn, 1, [0, 0, 0]);
		const centre = [spheres[4 * i], spheres[4 * i + 1], spheres[4 * i + 2]];
		place(berry.positions, positions, i * size, turn, spheres[4 * i + 3], centre);
	}
	return { uvs: berry.uvs, indices: berry.indices, positions, normals, pressed: new Uint8Array((size / 3) * count) };
}

/** The rotation that takes +Y to the unit vector (x, y, z) the shortest way, by rows. */
function turnFromUp(x: number, y: number, z: number): readonly number[] {
	if (y < -0.9999) return [1, 0, 0, 0, -1, 0, 0, 0, -1];
	const k = 1 / (1 + y);
	return [1 - x * x * k, x, -x * z * k, -x, y, -z, -x * z * k, z, 1 - z * z * k];
}

function place(
	from: Float32Array,
	to: Float32Array,
	at: number,
	turn: readonly number[],
	scale: number,
	centre: readonly number[],
): void {
	for (let v = 0; v < from.length; v += 3) {
		for (let k = 0; k < 3; k++) {
			const turned = turn[3 * k] * from[v] + turn[3 * k + 1] * from[v + 1] + turn[3 * k + 2] * from[v + 2];
			to[at + v + k] = scale * turned + centre[k];
		}
	}
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
