import type { Picture } from "./material";

/** Four numbers a pixel, the last one 255: as graphics cards take it, who make smaller copies of sRGB of four channels only. */
export function asCardsTakeIt(picture: Picture): Picture {
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
