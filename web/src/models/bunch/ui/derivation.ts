import type { DerivationSource } from "../../../grammar_editor/derivation_tool";
import type { DrawnGeometry, DrawnSurface } from "../../../plant/drawn";
import type { BunchPlant } from "../bunch_plant";
import type { BunchSpecimen } from "../specimen";
import { thinning } from "./thinning";

/**
 * Geometry of a bunch for the derivation stepper: internodes, and berries as organs, each with its own surface or the
 * shared one.
 */
export const derivation: DerivationSource<BunchSpecimen, BunchPlant> = {
	drawn: berriesDrawn,
	renderer: async () => new (await import("../../../render/lit_renderer")).LitRenderer(),
	taken: (context) => context.toolState(thinning).on,
};

/**
 * Returns the berries as they are drawn, so that a point on the screen finds one: with surfaces of their own, or the
 * shared mesh in their place.
 */
export function berriesDrawn({ internodes, berries, surfaces, berry }: BunchPlant): DrawnGeometry {
	const ownSurface = (index: number): DrawnSurface | undefined => {
		if (!surfaces) return undefined;
		const numbersPerBerry = 1.5 * surfaces.uvs.length;
		return {
			positions: surfaces.positions.subarray(numbersPerBerry * index, numbersPerBerry * (index + 1)),
			indices: surfaces.indices,
		};
	};
	const sharedSurface = (index: number): DrawnSurface | undefined => {
		if (!berry) return undefined;
		const [x, y, z, radius] = berries.spheres.subarray(4 * index, 4 * index + 4);
		return {
			positions: berry.positions,
			indices: berry.indices,
			transform: Float32Array.of(x, y, z, 0, 0, 0, 1, radius),
		};
	};
	return {
		ends: internodes.ends,
		radii: internodes.radii,
		organs: berries.count,
		surface: (index) => ownSurface(index) ?? sharedSurface(index),
	};
}
