/** A colour as the smallest picture, for readers that know pictures and colours of vertices, and no factor beside them (F3D). */
import { type Colour, clamp, encoded, linear } from "../plant/colour";
import type { Picture } from "../plant/material";

/** The picture, and the colour that is in it: never darker than the one asked for. */
export function onePixel(colour: Colour): { picture: Picture; colour: Colour } {
	const pixels = Uint8Array.from(encoded(colour), (value) => Math.ceil(255 * clamp(value) - 1e-6));
	const digits = Array.from(pixels, (value) => value.toString(16).padStart(2, "0")).join("");
	return { picture: { width: 1, height: 1, pixels }, colour: linear(digits) };
}
