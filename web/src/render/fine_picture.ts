/** Pictures with several samples per pixel: stems thinner than a pixel would be dashes. */
import type { Size } from "./size";

/** Most pixels that are drawn for a picture; larger pictures have one sample per pixel. */
const MAX_PIXELS = 2 ** 24;

/** Returns how many samples per pixel a picture has along each side: `wanted`, or 1 where that is too many pixels. */
export function samplesFor({ width, height }: Size, wanted: number): number {
	return width * height * wanted * wanted <= MAX_PIXELS ? wanted : 1;
}

/**
 * Returns the drawing on a canvas as a PNG of the given size: the mean of its pixels. Copies them before it returns.
 * @throws Error if the browser has no room for the picture
 */
export function finePicture(canvas: HTMLCanvasElement, { width, height }: Size): Promise<Blob> {
	const copy = new OffscreenCanvas(width, height);
	const context = copy.getContext("2d", { alpha: false });
	if (!context) throw new Error(`The browser has no room for ${width} × ${height} pixels; try a smaller picture.`);
	context.imageSmoothingQuality = "high";
	context.drawImage(canvas, 0, 0, width, height);
	return copy.convertToBlob({ type: "image/png" });
}
