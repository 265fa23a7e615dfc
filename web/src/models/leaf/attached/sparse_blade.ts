/**
 * A blade with few triangles, for crowns of thousands of leaves: the margin's most significant corners and the midrib.
 */
import { ShapeUtils, Vector2 } from "three";

/** Heights of the midrib's vertices, in leaf lengths: the leaf bends between them. */
const RIB = [0, 0.5, 1];

export interface SparseBlade {
	/**
	 * 2 × vertices, in leaf lengths, the base first. The halves have separate vertices on the midrib, for a sharp
	 * fold.
	 */
	points: Float32Array;
	/** 3 × triangles, counter-clockwise. */
	indices: Uint32Array;
}

/**
 * Builds the blade: each half is triangulated between its margin and the midrib.
 * @param margin 2 × points, counter-clockwise from the base
 * @param corners number of corners of each half's margin, besides base and tip
 */
export function sparseBlade(margin: Float32Array, corners: number): SparseBlade {
	const outline = Array.from({ length: margin.length / 2 }, (_, i) => new Vector2(margin[2 * i], margin[2 * i + 1]));
	const tip = outline.reduce((best, { y }, at) => (y > outline[best].y ? at : best), 0);
	const halves = [outline.slice(1, tip), outline.slice(tip + 1).reverse()];
	const blade: { points: number[]; indices: number[] } = { points: [], indices: [] };
	for (const [side, half] of [1, -1].map((sign, at) => [sign, halves[at]] as const)) {
		const rib = RIB.map((height) => new Vector2(0, height));
		const halfLine = [
			rib[0],
			...half.map(({ x, y }) => new Vector2(side * Math.max(0, side * x), y)),
			rib[rib.length - 1],
		];
		const outer = simplifiedLine(halfLine, corners).slice(1, -1);
		// Counter-clockwise from the base: up the margin and back along the midrib, or the reverse.
		const polygon = side > 0 ? [rib[0], ...outer, ...rib.slice(1).toReversed()] : [...rib, ...outer.toReversed()];
		const first = blade.points.length / 2;
		blade.points.push(...polygon.flatMap(({ x, y }) => [x, y]));
		blade.indices.push(
			...ShapeUtils.triangulateShape(polygon, [])
				.flat()
				.map((corner) => first + corner),
		);
	}
	return { points: Float32Array.from(blade.points), indices: Uint32Array.from(blade.indices) };
}

/**
 * Simplifies a line to its ends and `count` points: repeatedly removes the point that forms the smallest triangle with
 * its two neighbours (Visvalingam & Whyatt 1993).
 */
function simplifiedLine(line: readonly Vector2[], count: number): Vector2[] {
	const left = [...line];
	const area = (at: number) => Math.abs(ShapeUtils.area([left[at - 1], left[at], left[at + 1]]));
	while (left.length > count + 2) {
		let least = 1;
		for (let at = 2; at < left.length - 1; at++) if (area(at) < area(least)) least = at;
		left.splice(least, 1);
	}
	return left;
}
