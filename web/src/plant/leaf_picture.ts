/** What a leaf is laid with: its veins in colour. Vertices' colours multiply it. */
import { type Colour, encoded, mixed } from "./colour";
import type { Veins } from "./leaf";
import type { Picture } from "./material";

/** Of the veins' colour so much shows at the most. */
const MOST_VEIN = 0.85;

/**
 * @param blade between veins, linear
 * @param vein on a vein's axis, linear
 */
export function leafPicture({ side, shares }: Veins, blade: Colour, vein: Colour): Picture {
	const shades = Array.from({ length: 256 }, (_, share) =>
		encoded(mixed(blade, vein, (MOST_VEIN * share) / 255)).map((value) => Math.round(255 * Math.min(1, value))),
	);
	const pixels = new Uint8Array(3 * side * side);
	for (let at = 0; at < shares.length; at++) pixels.set(shades[shares[at]], 3 * at);
	return { width: side, height: side, pixels };
}
