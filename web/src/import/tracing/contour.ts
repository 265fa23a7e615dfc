/**
 * Traces the outline of a mask with one blob along the pixels' corners: clockwise on the screen, with the inside to
 * the right.
 */
import type { Mask, Pixel } from "./picture";

/** Right, down, left, up. */
const WAYS = [
	[1, 0],
	[0, 1],
	[-1, 0],
	[0, -1],
] as const;

/**
 * Follows the outer edge of the region in which the mask's first pixel lies; returns its corners, none for an empty
 * mask.
 */
export function contourOf({ width, height, inside }: Mask): Pixel[] {
	const start = inside.indexOf(1);
	if (start < 0) return [];
	const isInside = (x: number, y: number) => x >= 0 && y >= 0 && x < width && y < height && inside[y * width + x] === 1;
	// `way` is an index in WAYS.
	let [x, y, way] = [start % width, Math.floor(start / width), 0];
	const first = { x, y };
	const corners: Pixel[] = [];
	do {
		corners.push({ x, y });
		x += WAYS[way][0];
		y += WAYS[way][1];
		// The two pixels ahead of this corner, to the left and right of the direction.
		const [dx, dy] = WAYS[way];
		const right = isInside(dx > 0 || dy < 0 ? x : x - 1, dy > 0 || dx > 0 ? y : y - 1);
		const left = isInside(dx > 0 || dy > 0 ? x : x - 1, dx < 0 || dy > 0 ? y : y - 1);
		if (left && right) way = (way + 3) % 4;
		else if (!right) way = (way + 1) % 4;
	} while (x !== first.x || y !== first.y);
	return corners;
}

/**
 * Smooths a closed polygon by a Gaussian kernel over its points.
 * @param sigma standard deviation of the kernel, in points
 */
export function smoothed(polygon: readonly Pixel[], sigma: number): Pixel[] {
	const { length } = polygon;
	const half = Math.ceil(3 * sigma);
	const weights = Array.from({ length: 2 * half + 1 }, (_, k) => Math.exp(-((k - half) ** 2) / (2 * sigma * sigma)));
	const total = weights.reduce((sum, weight) => sum + weight, 0);
	return polygon.map((_, index) => {
		let [x, y] = [0, 0];
		weights.forEach((weight, k) => {
			const other = polygon[(index + k - half + half * length) % length];
			x += weight * other.x;
			y += weight * other.y;
		});
		return { x: x / total, y: y / total };
	});
}
