/**
 * Noise for pictures of bark. Pictures repeat at their edges, and their columns a quarter of the width apart are alike,
 * so that any whole number of quarters lies around a stem without a seam (BarkScale in wasm-core/src/stems/tubes.hpp).
 * Coordinates are shares of the picture, u across and v along, each 0 … 1.
 */
import { smoothstep } from "../colour";
import { hashFraction } from "../noise";

/** Numbers of quarters around stems that a picture is made for. */
export const QUARTERS = 4;

/** Smooth noise at a point, 0 … 1. */
export type NoiseField = (u: number, v: number) => number;

/**
 * Returns smooth noise of one octave.
 * @param across cells of the noise across the picture, a multiple of 4
 * @param along cells along it
 * @param stream number of an independent noise
 */
export function field(across: number, along: number, stream: number): NoiseField {
	const values = new Float32Array(across * along);
	const quarter = across / QUARTERS;
	for (let row = 0; row < along; row++)
		for (let column = 0; column < across; column++)
			values[row * across + column] = hashFraction((column % quarter === 0 ? 0 : column) + 4096 * row, stream);
	return (u, v) => {
		const x = (u - Math.floor(u)) * across;
		const y = (v - Math.floor(v)) * along;
		// Truncates to whole numbers, which is faster than Math.floor; a share of 1 by rounding counts as 0.
		const left = (x | 0) === across ? 0 : x | 0;
		const low = (y | 0) === along ? 0 : y | 0;
		const tx = x - (x | 0);
		const ty = y - (y | 0);
		const fx = tx * tx * (3 - 2 * tx);
		const fy = ty * ty * (3 - 2 * ty);
		const right = left + 1 === across ? 0 : left + 1;
		const below = low * across;
		const above = low + 1 === along ? 0 : below + across;
		const near = values[below + left] + fx * (values[below + right] - values[below + left]);
		const far = values[above + left] + fx * (values[above + right] - values[above + left]);
		return near + fy * (far - near);
	};
}

/** Returns 0 where noise crosses the middle of its range, and 1 farthest from it: lines that meet and part. */
export function ridge(noise: number): number {
	return Math.abs(2 * noise - 1);
}

/** Returns 0 at columns a quarter apart and 1 at some distance: sideways shifts times this leave those columns alike. */
export function besideSeams(u: number): number {
	const off = QUARTERS * u - Math.round(QUARTERS * u);
	return smoothstep(0, 0.25, Math.abs(off));
}

/** Marks that are wider than high, such as lenticels. All lengths as shares of the picture. */
export interface BarkMarks {
	readonly count: number;
	readonly width: readonly [least: number, most: number];
	readonly height: readonly [least: number, most: number];
	/** Rows in which marks gather; any height where absent. */
	readonly rows?: number;
	readonly stream: number;
}

/**
 * Returns marks as a picture: 1 in the middle of a mark, 0 outside. Marks keep between columns a quarter apart, and a
 * few lie across all of those columns.
 */
export function marks({ count, width, height, rows, stream }: BarkMarks, pixelsAcross: number, pixelsAlong: number) {
	const picture = new Float32Array(pixelsAcross * pixelsAlong);
	const random = (mark: number, number: number) => hashFraction(8 * mark + number, stream);
	const between = ([least, most]: readonly [number, number], share: number) => least + share * share * (most - least);
	const stamp = (u: number, v: number, w: number, h: number, strength: number) => {
		for (let y = Math.floor((v - h) * pixelsAlong); y <= Math.ceil((v + h) * pixelsAlong); y++)
			for (let x = Math.floor((u - w) * pixelsAcross); x <= Math.ceil((u + w) * pixelsAcross); x++) {
				const dx = ((x + 0.5) / pixelsAcross - u) / w;
				const dy = ((y + 0.5) / pixelsAlong - v) / h;
				const value = strength * smoothstep(1, 0.55, Math.sqrt(dx * dx + dy * dy * (1 + 2 * dx * dx)));
				const at = wrapped(y, pixelsAlong) * pixelsAcross + wrapped(x, pixelsAcross);
				picture[at] = Math.max(picture[at], value);
			}
	};
	for (let mark = 0; mark < count; mark++) {
		const w = 0.5 * between(width, random(mark, 0));
		const h = 0.5 * between(height, random(mark, 1));
		const row = random(mark, 2);
		const v = rows === undefined ? row : (Math.floor(row * rows) + 0.5 + 0.3 * (random(mark, 3) - 0.5)) / rows;
		const strength = 0.6 + 0.4 * random(mark, 4);
		const quarter = 1 / QUARTERS;
		if (mark % 8 === 7)
			for (let k = 0; k < QUARTERS; k++) stamp(k * quarter + w * (random(mark, 5) - 0.5), v, w, h, strength);
		else {
			const room = Math.max(0, quarter - 2 * w - 2 / pixelsAcross);
			const side = quarter * Math.floor(QUARTERS * random(mark, 6));
			stamp(side + 0.5 * quarter + room * (random(mark, 5) - 0.5), v, w, h, strength);
		}
	}
	return picture;
}

/** Returns the remainder, 0 … `count` − 1, also of negative numbers. */
export function wrapped(cell: number, count: number): number {
	return ((cell % count) + count) % count;
}
