/**
 * One card for each leaf or twig, or for evenly chosen ones that are enlarged to cover the same area (Cook et al. 2007,
 * "Stochastic simplification of aggregate detail"): the finest level of a tree of cards.
 */
import type { PartMesh, Vector } from "../../plant/part";
import type { Card } from "./card";
import type { CrownFoliage, CrownLeaf, CrownLeafKind } from "./foliage";
import type { Skeleton } from "./skeleton";
import type { Tubes } from "./tubes";
import { add, scaled } from "./vectors";
import { WoodGrid } from "./wood_grid";

/** The outline of a kind's card in the plane of its mesh: points (x, y) in the mesh's frame. */
export interface CardOutline {
	readonly corners: readonly (readonly [x: number, y: number])[];
	/** The box around the corners. */
	readonly low: readonly [x: number, y: number];
	readonly high: readonly [x: number, y: number];
}

/** The cards of each kind of leaves. */
export interface KindCards {
	readonly outlines: readonly CardOutline[];
	/** By how much they are larger than their leaves. */
	readonly factors: readonly number[];
	/** Converts a point in the plane of a kind's mesh to texture coordinates. */
	uvOf(kind: number, x: number, y: number): readonly [u: number, v: number];
}

/** Half angles at the tip of triangles that are tried, as widths per height. */
const SLOPES = Array.from({ length: 24 }, (_, i) => 0.08 * 1.2 ** i);
/** A leaf nearer to its stem than this share of the tree's height is attached to it; others fall or lie on the ground. */
const ATTACHED = 0.02;

/** Returns the smallest upright triangle, tip up or down, that holds a mesh seen from the front; or its box. */
export function outlineOf({ positions }: PartMesh, triangle: boolean): CardOutline {
	const xs: number[] = [];
	const ys: number[] = [];
	for (let i = 0; i < positions.length; i += 3) {
		xs.push(positions[i]);
		ys.push(positions[i + 1]);
	}
	const [left, right] = [Math.min(...xs), Math.max(...xs)];
	const [bottom, top] = [Math.min(...ys), Math.max(...ys)];
	const box: CardOutline["corners"] = [
		[left, bottom],
		[right, bottom],
		[left, top],
		[right, top],
	];
	if (!triangle) return { corners: box, low: [left, bottom], high: [right, top] };
	let best: CardOutline["corners"] = [];
	let least = Number.POSITIVE_INFINITY;
	for (const slope of SLOPES) {
		for (const up of [1, -1]) {
			// Sides x = ±slope · (tip − y) moved outwards until all points are inside.
			let [toRight, toLeft] = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
			for (const [i, x] of xs.entries()) {
				toRight = Math.max(toRight, x + slope * up * ys[i]);
				toLeft = Math.min(toLeft, x - slope * up * ys[i]);
			}
			const base = up > 0 ? bottom : top;
			const [a, b] = [toLeft + slope * up * base, toRight - slope * up * base];
			const tip = (up * (toRight - toLeft)) / (2 * slope);
			const area = (b - a) * Math.abs(tip - base);
			if (area >= least) continue;
			least = area;
			const middle = 0.5 * (toLeft + toRight);
			best =
				up > 0
					? [
							[a, base],
							[b, base],
							[middle, tip],
						]
					: [
							[b, base],
							[a, base],
							[middle, tip],
						];
		}
	}
	const at = (axis: 0 | 1, pick: (...values: number[]) => number) => pick(...best.map((corner) => corner[axis]));
	return { corners: best, low: [at(0, Math.min), at(1, Math.min)], high: [at(0, Math.max), at(1, Math.max)] };
}

/**
 * Makes the cards.
 * @param count the most cards
 */
export function twigCards(
	{ leaves, kinds }: CrownFoliage,
	skeleton: Skeleton,
	{ retained }: Tubes,
	count: number,
	{ outlines, factors, uvOf }: KindCards,
): Card[] {
	const [all, left] = [new WoodGrid(skeleton), new WoodGrid(skeleton, retained)];
	// Leaves whose stem is left out move to the nearest one that is left.
	const anchorOf = (place: Vector) => {
		const own = all.nearest(place);
		const isLoose = own.distance > ATTACHED * skeleton.height || retained[skeleton.stemOf[own.segment]] === 1;
		if (isLoose) return { anchor: place, segment: own.segment };
		const { place: anchor, segment } = left.nearest(place);
		return { anchor, segment };
	};
	const chosen = evenly(leaves, count);
	const larger = Math.sqrt(leaves.length / Math.max(1, chosen.length));
	const depths = kinds.map(meanDepth);
	return chosen.map((leaf): Card => {
		const { kind, place, axes, sky } = leaf;
		const [across, along, face] = axes;
		const scale = leaf.scale * larger * factors[kind];
		const { anchor, segment } = anchorOf(place);
		const origin = add(anchor, scaled(face, scale * depths[kind]));
		const corners = outlines[kind].corners.map(([x, y]): Vector => {
			return add(origin, add(scaled(across, scale * x), scaled(along, scale * y)));
		});
		return { corners, uvs: outlines[kind].corners.map(([x, y]) => uvOf(kind, x, y)), face, anchor, segment, sky };
	});
}

/** Returns every leaf, or evenly chosen ones. Leaves follow each other in the order of growth. */
function evenly(leaves: readonly CrownLeaf[], count: number): readonly CrownLeaf[] {
	if (leaves.length <= count) return leaves;
	return Array.from({ length: count }, (_, i) => leaves[Math.floor(((i + 0.5) * leaves.length) / count)]);
}

/** Returns the mean of z over a kind's vertices: its card passes through the middle of a twig that is not flat. */
function meanDepth({ shape: { mesh } }: CrownLeafKind): number {
	let sum = 0;
	for (let i = 2; i < mesh.positions.length; i += 3) sum += mesh.positions[i];
	return sum / Math.max(1, mesh.positions.length / 3);
}
