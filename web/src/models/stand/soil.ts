/** The ground for display and files: subdivided (finer_ground.ts), with a rim (rim.ts), and mottled. Pure. */
import { hashFraction, noise } from "../../plant/noise";
import type { PartMesh } from "../../plant/part";
import { finerGround } from "./finer_ground";
import { withRim } from "./rim";

/** Mottles along the shorter side, and their contrast. */
const MOTTLES = 9;
const CONTRAST = 0.6;

export interface Soil {
	readonly mesh: PartMesh;
	/** Factor of the ground's colour at each vertex. */
	readonly light: Float32Array;
	/** Distance of each vertex into the rim: 0 on the ground, 1 at the outer end. */
	readonly rim: Float32Array;
}

/**
 * Builds the soil for display: subdivides the ground, adds a rim and computes mottles.
 * @param mesh the ground's mesh from the core; its first vertex is a corner
 */
export function soilOf(mesh: PartMesh): Soil {
	const [x, , z] = mesh.positions;
	const shorterSide = Math.min(-2 * x, -2 * z);
	const { mesh: rimmed, rim } = withRim(finerGround(mesh), shorterSide);
	return { mesh: { ...mesh, ...rimmed }, light: mottles(rimmed.positions, shorterSide), rim };
}

/**
 * Returns a factor on the colour of each vertex, from noise.
 * @param positions 3 × vertices, metres
 * @param shorterSide length of the ground's shorter side, metres
 */
function mottles(positions: Float32Array, shorterSide: number): Float32Array {
	const scale = MOTTLES / shorterSide;
	return Float32Array.from({ length: positions.length / 3 }, (_, v) => {
		const [x, z] = [scale * positions[3 * v], scale * positions[3 * v + 2]];
		const light = 0.5 * noise(x, 0, z) + 0.3 * noise(2.3 * x, 1, 2.3 * z) + 0.2 * hashFraction(v, 5);
		return 1 + CONTRAST * (2 * light - 1);
	});
}
