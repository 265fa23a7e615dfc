import type { Foliage } from "../bunch_plant";

/** Number of discs that approximate a leaf's shadow. */
const DISCS = 28;
/**
 * Radius of a disc as a share of half the leaf's greatest extent: neighbours overlap, and the outline remains
 * leaf-like.
 */
const SHARE = 0.24;

/** Returns leaves as spheres, for their soft shadow on the paper: 4 numbers each, centre and radius in metres. */
export function leafDiscs({ parts, positions }: Foliage): Float32Array {
	const discs: number[] = [];
	for (const { kind, firstVertex, vertexCount } of parts) {
		if (kind !== "leaf") continue;
		const halfExtent = 0.5 * extentOf(positions.subarray(3 * firstVertex, 3 * (firstVertex + vertexCount)));
		const step = Math.max(1, Math.floor(vertexCount / DISCS));
		for (let v = firstVertex; v < firstVertex + vertexCount; v += step) {
			discs.push(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2], SHARE * halfExtent);
		}
	}
	return Float32Array.from(discs);
}

/** Returns the longest side of the points' bounding box. */
function extentOf(points: Float32Array): number {
	let longest = 0;
	for (let k = 0; k < 3; k++) {
		let [low, high] = [Infinity, -Infinity];
		for (let i = k; i < points.length; i += 3) {
			low = Math.min(low, points[i]);
			high = Math.max(high, points[i]);
		}
		longest = Math.max(longest, high - low);
	}
	return longest;
}
