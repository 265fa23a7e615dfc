/** Grids over the square of the flat leaf, rows from the bottom. */
import type { Chart } from "../grown";

/** Converts 2 × points from leaf lengths to coordinates in cells of a grid of side × side cells. */
export function inCells(points: Float32Array, { left, bottom, size }: Chart, side: number): Float32Array {
	return points.map((value, at) => ((value - (at % 2 === 0 ? left : bottom)) / size) * side);
}

/**
 * Returns 1 for each cell whose centre is inside a margin, else 0: row by row between the intersections.
 * @param margin 2 × points, in cells
 */
export function insideOf(margin: Float32Array, side: number): Uint8Array {
	const inside = new Uint8Array(side * side);
	const crossings: number[][] = Array.from({ length: side }, () => []);
	const count = margin.length / 2;
	for (let i = 0; i < count; i++) {
		const j = (i + 1) % count;
		const [x1, y1, x2, y2] = [margin[2 * i], margin[2 * i + 1], margin[2 * j], margin[2 * j + 1]];
		const last = Math.min(side - 1, Math.ceil(Math.max(y1, y2) - 0.5) - 1);
		for (let row = Math.max(0, Math.ceil(Math.min(y1, y2) - 0.5)); row <= last; row++) {
			crossings[row].push(x1 + ((row + 0.5 - y1) / (y2 - y1)) * (x2 - x1));
		}
	}
	crossings.forEach((xs, row) => {
		xs.sort((a, b) => a - b);
		for (let k = 0; k + 1 < xs.length; k += 2) {
			const [begin, end] = [Math.max(0, Math.ceil(xs[k] - 0.5)), Math.min(side, Math.ceil(xs[k + 1] - 0.5))];
			inside.fill(1, row * side + begin, row * side + Math.max(begin, end));
		}
	});
	return inside;
}

/**
 * Computes the distance transform in place: the distance of each cell from the nearest zero, in cells, by two chamfer
 * passes (Borgefors 1986). Other initial values only have to be large enough.
 */
export function distanceTransform(distances: Float32Array, side: number): void {
	for (let at = 0; at < distances.length; at++) {
		const column = at % side;
		let nearest = distances[at];
		if (column > 0) nearest = Math.min(nearest, distances[at - 1] + 1);
		if (at >= side) {
			nearest = Math.min(nearest, distances[at - side] + 1);
			if (column > 0) nearest = Math.min(nearest, distances[at - side - 1] + Math.SQRT2);
			if (column < side - 1) nearest = Math.min(nearest, distances[at - side + 1] + Math.SQRT2);
		}
		distances[at] = nearest;
	}
	for (let at = distances.length - 1; at >= 0; at--) {
		const column = at % side;
		let nearest = distances[at];
		if (column < side - 1) nearest = Math.min(nearest, distances[at + 1] + 1);
		if (at + side < distances.length) {
			nearest = Math.min(nearest, distances[at + side] + 1);
			if (column < side - 1) nearest = Math.min(nearest, distances[at + side + 1] + Math.SQRT2);
			if (column > 0) nearest = Math.min(nearest, distances[at + side - 1] + Math.SQRT2);
		}
		distances[at] = nearest;
	}
}
