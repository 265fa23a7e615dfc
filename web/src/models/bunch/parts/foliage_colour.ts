/** The colours of leaves, petioles and cane: the view's shader patterns them, files have their means. */
import { type Colour, linear, mixed, smoothstep } from "../../../plant/colour";

/** A leaf's faces, and what autumn makes of them; where veins run they are paler. */
export const LEAF = { upper: linear("476a2e"), lower: linear("7f9a63"), late: [0.42, 0.27, 0.045] as Colour } as const;
/** A leaf turns between these shares of autumn. */
export const AUTUMN = [0.55, 0.95] as const;
export const PETIOLE = linear("8c8f4a");
/** A year old cane's bark. */
export const CANE = linear("7a5a3c");
/** Filaments, and anthers of pollen's colour. */
export const STAMEN = { filament: linear("e3e6bd"), anther: linear("e6d37c") } as const;
/** Where filaments end and anthers begin, as v (models/bunch/fruit/flower.hpp). */
export const ANTHER_V = 0.5;

/** The light that the shader's patterns take or add, in the mean. */
const PATTERN = { green: 1.025, late: 0.95 } as const;

/**
 * A leaf's mean colour, seen from above.
 * @param autumn 0 … 1
 */
export function leafColour(autumn: number): Colour {
	const turned = smoothstep(AUTUMN[0], AUTUMN[1], autumn);
	const scaled = (colour: Colour, factor: number) => colour.map((value) => value * factor) as Colour;
	return mixed(scaled(LEAF.upper, PATTERN.green), scaled(LEAF.late, PATTERN.late), turned);
}
