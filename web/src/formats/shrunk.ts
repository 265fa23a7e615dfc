/** Smaller pictures. */
import type { Picture } from "../plant/material";

/** Halves a picture until no side is longer than `most` pixels, each pixel the mean of four. */
export function shrunk(picture: Picture, most: number): Picture {
	const { width, height, pixels } = picture;
	if (Math.max(width, height) <= most) return picture;
	const channels = pixels.length / (width * height);
	const [w, h] = [Math.max(1, width >> 1), Math.max(1, height >> 1)];
	const half = new Uint8Array(channels * w * h);
	for (let y = 0, to = 0; y < h; y++) {
		const upper = channels * width * 2 * y;
		const lower = channels * width * Math.min(height - 1, 2 * y + 1);
		for (let x = 0; x < w; x++) {
			const left = channels * 2 * x;
			const right = channels * Math.min(width - 1, 2 * x + 1);
			for (let k = 0; k < channels; k++, to++) {
				const sum =
					pixels[upper + left + k] + pixels[upper + right + k] + pixels[lower + left + k] + pixels[lower + right + k];
				half[to] = Math.round(sum / 4);
			}
		}
	}
	return shrunk({ width: w, height: h, pixels: half }, most);
}
