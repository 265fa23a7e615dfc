import { clamp } from "../../../plant/colour";
import { fromUp, placeVectors, rotationMatrix } from "../../../plant/orientation";
import type { Berries, BerrySurfaces, BunchPlant, SharedBerry } from "../bunch_plant";

/** Vertices per row of their texture. */
export const VERTICES_PER_ROW = 1024;

/**
 * Returns the surfaces of all berries: their own if the procedure made them, else the shared berry at each sphere.
 * Undefined if only the skeleton was requested.
 */
export function surfacesOf({ surfaces, berry, berries }: BunchPlant): BerrySurfaces | undefined {
	return surfaces ?? (berry && copyToEachBerry(berry, berries));
}

/** Returns the shared berry's mesh at the place, direction and size of each berry; nothing is pressed. */
function copyToEachBerry(berry: SharedBerry, { count, spheres, directions }: Berries): BerrySurfaces {
	const size = berry.positions.length;
	const positions = new Float32Array(size * count);
	const normals = new Float32Array(size * count);
	for (let i = 0; i < count; i++) {
		const [x, y, z, radius] = spheres.subarray(4 * i, 4 * i + 4);
		const turn = rotationMatrix(fromUp(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]));
		placeVectors(berry.normals, turn, 1, [0, 0, 0], normals, i * size);
		placeVectors(berry.positions, turn, radius, [x, y, z], positions, i * size);
	}
	const pressed = new Uint8Array((size / 3) * count);
	const { uvs, indices, sky } = berry;
	return { uvs, indices, positions, normals, pressed, sky };
}

/** Steps of the 16-bit numbers in a word. */
const STEPS = 65535;

/**
 * Packs vertices into texels of four words, low half first: x and y; z, `pressed` and `sky` in 8 bits each; the
 * normal's octahedral map (Cigolle et al. 2014, "A survey of efficient representations for independent unit vectors");
 * unused. Positions are relative to the berry's centre, as shares of its reach, −1 … 1. The vertex shader
 * (berry_shader.ts) unpacks them.
 * @param words at least 4 × vertices
 * @returns the reach of each berry, metres
 */
export function packVertices(
	{ uvs, positions, normals, pressed, sky }: BerrySurfaces,
	{ count, spheres }: Berries,
	words: Uint32Array,
): Float32Array {
	const vertices = uvs.length / 2;
	const reaches = new Float32Array(count);
	for (let berry = 0, at = 0; berry < count; berry++) {
		const x = spheres[4 * berry];
		const y = spheres[4 * berry + 1];
		const z = spheres[4 * berry + 2];
		const end = 3 * vertices * (berry + 1);
		// The greatest distance of a vertex from the centre, along any axis.
		let reach = 1e-9;
		for (let v = 3 * vertices * berry; v < end; v += 3) {
			reach = Math.max(
				reach,
				Math.abs(positions[v] - x),
				Math.abs(positions[v + 1] - y),
				Math.abs(positions[v + 2] - z),
			);
		}
		reaches[berry] = reach;
		const scale = (0.5 * STEPS) / reaches[berry];
		for (let v = 3 * vertices * berry; v < end; v += 3, at += 4) {
			const i = v / 3;
			words[at] = packPair((positions[v] - x) * scale, (positions[v + 1] - y) * scale);
			words[at + 1] = packPair((positions[v + 2] - z) * scale, -0.5 * STEPS) | (pressed[i] << 16);
			words[at + 1] |= (sky ? sky[i] : 255) << 24;
			words[at + 2] = packNormal(normals[v], normals[v + 1], normals[v + 2]);
		}
	}
	return reaches;
}

/** Packs two numbers of −STEPS / 2 … STEPS / 2 into 32 bits, the first in the lower half. */
function packPair(first: number, second: number): number {
	return (
		(Math.round(clamp(first + 0.5 * STEPS, 0, STEPS)) | (Math.round(clamp(second + 0.5 * STEPS, 0, STEPS)) << 16)) >>> 0
	);
}

/**
 * Packs a normal into 32 bits by octahedral projection: x and y on the octahedron, whose lower half is folded outwards.
 */
function packNormal(x: number, y: number, z: number): number {
	const sum = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
	let u = x / sum;
	let v = y / sum;
	if (z < 0) {
		const folded = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
		v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
		u = folded;
	}
	return packPair(0.5 * STEPS * u, 0.5 * STEPS * v);
}

/** Returns the sky visibility of each berry, 0 … 1: the mean over its surface. */
export function skiesOf({ uvs, sky }: BerrySurfaces, count: number): Float32Array {
	const skies = new Float32Array(count).fill(1);
	if (!sky) return skies;
	const vertices = uvs.length / 2;
	for (let berry = 0; berry < count; berry++) {
		let sum = 0;
		for (let i = vertices * berry; i < vertices * (berry + 1); i++) sum += sky[i];
		skies[berry] = sum / vertices / 255;
	}
	return skies;
}
