/**
 * A colour as the smallest picture, for readers that support pictures and vertex colours, but no factor besides (F3D).
 */
import { type Colour, clamp, encoded, linear } from "../plant/colour";
import type { Picture } from "../plant/material";

/** Returns a picture of one pixel, and its colour in linear light: never darker than the given one. */
export function onePixel(colour: Colour): { picture: Picture; colour: Colour } {
	const pixels = Uint8Array.from(encoded(colour), (value) => Math.ceil(255 * clamp(value) - 1e-6));
	const digits = Array.from(pixels, (value) => value.toString(16).padStart(2, "0")).join("");
	return { picture: { width: 1, height: 1, pixels }, colour: linear(digits) };
}
