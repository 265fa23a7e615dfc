import { type Matrix4, SphericalHarmonics3, Vector3 } from "three";
import type { Lobe } from "./light";

/** Steps of the integral over a lobe. */
const STEPS = 64;

/**
 * Computes the integral of a lobe in the bands l = 0, 1, 2 by the midpoint rule: 2π ∫ P_l(x) exp(s (x − 1)) dx over −1
 * … 1, with s the sharpness and P_l the Legendre polynomial.
 */
function bandsOf(sharpness: number): [number, number, number] {
	const bands: [number, number, number] = [0, 0, 0];
	for (let i = 0; i < STEPS; i++) {
		const x = -1 + (2 * (i + 0.5)) / STEPS;
		const weight = ((2 * Math.PI * 2) / STEPS) * Math.exp(sharpness * (x - 1));
		bands[0] += weight;
		bands[1] += weight * x;
		bands[2] += weight * (1.5 * x * x - 0.5);
	}
	return bands;
}

/**
 * Returns the light of the surroundings as spherical harmonics of three bands, for three's light probe: sufficient for
 * the diffuse light of matt surfaces (Ramamoorthi & Hanrahan 2001, "An efficient representation for irradiance
 * environment maps").
 * @param cameraWorld matrix of the camera, which turns the lobes
 */
export function probeOf(lobes: readonly Lobe[], cameraWorld: Matrix4): SphericalHarmonics3 {
	const harmonics = new SphericalHarmonics3();
	const basis = new Array<number>(9).fill(0);
	for (const { axis, sharpness, colour } of lobes) {
		const bands = bandsOf(sharpness);
		SphericalHarmonics3.getBasisAt(new Vector3().copy(axis).transformDirection(cameraWorld), basis);
		harmonics.coefficients.forEach((coefficient, i) => {
			const band = bands[i === 0 ? 0 : i < 4 ? 1 : 2];
			coefficient.addScaledVector(new Vector3(...colour), band * basis[i]);
		});
	}
	return harmonics;
}
