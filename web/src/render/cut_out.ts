/** Separates a plant from its background by two pictures, over black and over white (Porter & Duff 1984, "matting"). */
import type { Size } from "./size";

/**
 * Computes a picture with a transparent background from two opaque ones of the same scene, RGBA bytes each. The
 * difference of both is the visible share of the background; 255 minus that is the alpha, which divides the colours.
 */
export function cutOut(onBlack: Uint8ClampedArray, onWhite: Uint8ClampedArray): Uint8ClampedArray<ArrayBuffer> {
	const cut = new Uint8ClampedArray(onBlack.length);
	for (let pixel = 0; pixel < cut.length; pixel += 4) {
		const ground =
			(onWhite[pixel] -
				onBlack[pixel] +
				onWhite[pixel + 1] -
				onBlack[pixel + 1] +
				onWhite[pixel + 2] -
				onBlack[pixel + 2]) /
			3;
		const cover = Math.min(255, Math.max(0, 255 - ground));
		for (let k = 0; k < 3; k++) cut[pixel + k] = cover > 0 ? (255 * onBlack[pixel + k]) / cover : 0;
		cut[pixel + 3] = cover;
	}
	return cut;
}

/**
 * Returns the drawing on a canvas as a PNG with a transparent background. All drawing is finished when the call
 * returns.
 * @param size of the picture, pixels; the drawing may be larger, and is then averaged
 * @param draw draws over black (0), over white (1), or over the usual background; the last call always restores the
 * usual background, even after an error
 */
export function cutOutOf(
	canvas: HTMLCanvasElement,
	{ width, height }: Size,
	draw: (ground?: 0 | 1) => void,
): Promise<Blob> {
	try {
		draw(0);
		const copy = new OffscreenCanvas(width, height);
		const context = copy.getContext("2d", { willReadFrequently: true });
		if (!context) throw new Error(`The browser has no room for ${width} × ${height} pixels; try a smaller picture.`);
		const copied = () => {
			context.drawImage(canvas, 0, 0, width, height);
			return context.getImageData(0, 0, width, height).data;
		};
		const onBlack = copied();
		draw(1);
		const onWhite = copied();
		context.putImageData(new ImageData(cutOut(onBlack, onWhite), width, height), 0, 0);
		return copy.convertToBlob({ type: "image/png" });
	} finally {
		draw();
	}
}
