import type { Foliage } from "../bunch_plant";

/** Discs that a leaf's shadow is laid with. */
const DISCS = 28;
/** Their radius as a share of the leaf's half breadth: neighbours overlap, the outline stays a leaf's. */
const SHARE = 0.24;

/** Leaves as balls, for the soft shadow they cast on the paper: 4 numbers each, centre and radius in metres. */
export function leafDiscs({ parts, positions }: Foliage): Float32Array {
	const discs: number[] = [];
	for (const { kind, firstVertex, vertexCount } of parts) {
		if (kind !== "leaf") continue;
		const reach = 0.5 * extentOf(positions.subarray(3 * firstVertex, 3 * (firstVertex + vertexCount)));
		const step = Math.max(1, Math.floor(vertexCount / DISCS));
		for (let v = firstVertex; v < firstVertex + vertexCount; v += step) {
			discs.push(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2], SHARE * reach);
		}
	}
	return Float32Array.from(discs);
}

/** The longest side of the points' box. */
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
