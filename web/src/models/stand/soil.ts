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

/** @param mesh the ground's mesh from the core */
export function soilOf(mesh: PartMesh): Soil {
	const [x, , z] = mesh.positions;
	const short = Math.min(-2 * x, -2 * z);
	const { mesh: made, rim } = withRim(finerGround(mesh), short);
	return { mesh: { ...mesh, ...made }, light: mottled(made.positions, short), rim };
}

function mottled(places: Float32Array, short: number): Float32Array {
	const scale = MOTTLES / short;
	return Float32Array.from({ length: places.length / 3 }, (_, v) => {
		const [x, z] = [scale * places[3 * v], scale * places[3 * v + 2]];
		const light = 0.5 * noise(x, 0, z) + 0.3 * noise(2.3 * x, 1, 2.3 * z) + 0.2 * hashFraction(v, 5);
		return 1 + CONTRAST * (2 * light - 1);
	});
}
