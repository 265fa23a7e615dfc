/** Turns a traced margin upright and scales it to its own length. */
import type { Point } from "../../ui/handles/point";
import type { Pixel } from "./picture";

/**
 * Returns the margin in units of its length, counter-clockwise from the base, with its centroid straight above the
 * base, and that length in pixels. The tip is not used for the direction, because there may be two tips, or a bent one.
 * @param contour clockwise on the screen, pixels
 * @param base pixel where the margin begins
 */
export function upright(contour: readonly Pixel[], base: Pixel): { margin: Point[]; size: number } {
	const first = nearest(contour, base);
	const { length } = contour;
	const [x, y] = contour.reduce((sum, pixel) => [sum[0] + pixel.x / length, sum[1] + pixel.y / length], [0, 0]);
	const far = Math.hypot(x - base.x, y - base.y) || 1;
	const [ux, uy] = [(x - base.x) / far, (y - base.y) / far];
	const along = contour.map((pixel) => (pixel.x - base.x) * ux + (pixel.y - base.y) * uy);
	const size = along.reduce((best, value) => Math.max(best, value), 1);
	const turned = contour.map((pixel, index) => ({
		x: ((pixel.y - base.y) * ux - (pixel.x - base.x) * uy) / size,
		y: along[index] / size,
	}));
	// The contour is clockwise on the screen, so it is read backwards.
	return { margin: [turned[first], ...turned.slice(0, first).reverse(), ...turned.slice(first + 1).reverse()], size };
}

/** Returns the index of the pixel nearest to a point. */
function nearest(pixels: readonly Pixel[], to: Pixel): number {
	const away = pixels.map(({ x, y }) => Math.hypot(x - to.x, y - to.y));
	return away.reduce((best, value, index) => (value < away[best] ? index : best), 0);
}
