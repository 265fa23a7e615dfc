/** Waxy bloom on a berry's skin: its depth at a point, and the share of skin that it hides. */
import { mix, smoothstep } from "../../../plant/colour";
import { WAX } from "./skin_rules";

/**
 * Returns the optical depth of wax at a point.
 * @param bloom of the berry, 0 … 1
 * @param coarse noise at the point, 0 … 1; `fine` is finer than vertices
 * @param up how far its normal points up, −1 … 1
 * @param pressed 0 free … 1 in contact with a neighbour
 */
export function waxDepth(bloom: number, coarse: number, fine: number, up: number, pressed: number): number {
	const touched = smoothstep(WAX.pressed[0], WAX.pressed[1], pressed + WAX.pressedFine * (fine - 0.5));
	const unbrushed = (1 - touched) * smoothstep(WAX.brushed[0], WAX.brushed[1], coarse + WAX.fine * fine);
	const patches = smoothstep(WAX.patches[0], WAX.patches[1], WAX.coarseShare * coarse + WAX.fineShare * fine);
	return WAX.depth * bloom * mix(WAX.rubbed, 1, unbrushed) * mix(WAX.bare, 1, patches) * (WAX.side + WAX.up * up);
}

/** Returns the share of the skin that wax of a depth hides, seen face on. */
export function hiddenBy(depth: number): number {
	return 1 - Math.exp(-depth / (WAX.grazing + 1));
}
