/** The picture of a leaf: its veins in colour. Vertex colours multiply it. */
import { type Colour, encoded, mixed } from "./colour";
import type { Veins } from "./leaf";
import type { Picture } from "./material";

/** The largest share of the veins' colour. */
const MAX_VEIN = 0.85;

/**
 * Draws the picture: each pixel's share of a vein mixes the two colours.
 * @param blade between veins, linear
 * @param vein on a vein's axis, linear
 */
export function leafPicture({ side, shares }: Veins, blade: Colour, vein: Colour): Picture {
	const shades = new Uint8Array(3 * 256);
	for (let share = 0; share < 256; share++) {
		const shade = encoded(mixed(blade, vein, (MAX_VEIN * share) / 255));
		for (let k = 0; k < 3; k++) shades[3 * share + k] = Math.round(255 * Math.min(1, shade[k]));
	}
	const pixels = new Uint8Array(3 * side * side);
	for (let from = 0, to = 0; from < shares.length; from++, to += 3) {
		const shade = 3 * shares[from];
		pixels[to] = shades[shade];
		pixels[to + 1] = shades[shade + 1];
		pixels[to + 2] = shades[shade + 2];
	}
	return { width: side, height: side, pixels };
}
