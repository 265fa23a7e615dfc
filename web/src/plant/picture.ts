/** Conversions of pictures for drawing. */
import { type Colour, clamp, encoded, linear } from "./colour";
import type { Picture } from "./material";

/**
 * Returns a picture with four numbers per pixel, the last one 255: graphics cards make smaller copies of sRGB only with
 * four channels.
 */
export function rgbaPicture(picture: Picture): Picture {
	const { width, height, pixels } = picture;
	if (pixels.length === 4 * width * height) return picture;
	const four = new Uint8Array(4 * width * height);
	for (let from = 0, to = 0; to < four.length; from += 3, to += 4) {
		four[to] = pixels[from];
		four[to + 1] = pixels[from + 1];
		four[to + 2] = pixels[from + 2];
		four[to + 3] = 255;
	}
	return { width, height, pixels: four };
}

/** Returns the picture multiplied by a colour; the same picture where that is white. */
export function tinted(picture: Picture, by: Colour): Picture {
	if (by.every((channel) => channel === 1)) return picture;
	const shades = by.map((channel) =>
		Uint8Array.from({ length: 256 }, (_, value) => {
			const light = linear(`#${value.toString(16).padStart(2, "0").repeat(3)}`)[0] * channel;
			return Math.round(255 * clamp(encoded([light, light, light])[0]));
		}),
	);
	const channels = picture.pixels.length / (picture.width * picture.height);
	// Coverage stays as it is.
	const pixels = picture.pixels.map((value, at) => shades[at % channels]?.[value] ?? value);
	return { ...picture, pixels };
}
