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

export function berriesDrawn({ internodes, berries, surfaces, berry }: BunchPlant): DrawnGeometry {
	const own = (index: number): DrawnSurface | undefined => {
		if (!surfaces) return undefined;
		const numbers = 1.5 * surfaces.uvs.length;
		return {
			positions: surfaces.positions.subarray(numbers * index, numbers * (index + 1)),
			indices: surfaces.indices,
		};
	};
	const shared = (index: number): DrawnSurface | undefined => {
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
		surface: (index) => own(index) ?? shared(index),
	};
}
