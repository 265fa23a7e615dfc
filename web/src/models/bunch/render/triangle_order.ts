/**
 * Triangles ordered together: software renderers draw 128 at a time with a cache of 64 vertices; these have about as
 * many.
 */
const TOGETHER = 64;

/**
 * Reorders triangles for software renderers: triangles with three new vertices first, then two, then one. Such
 * renderers process vertices in fours, from the first uncached one of the list: neighbouring triangles then share most
 * of the four.
 * @param indices 3 × triangles
 */
export function triangleOrder(indices: Uint32Array): Uint32Array {
	const ordered = new Uint32Array(indices.length);
	for (let first = 0; first < indices.length; first += 3 * TOGETHER) {
		ordered.set(orderOf(indices.subarray(first, first + 3 * TOGETHER)), first);
	}
	return ordered;
}

/**
 * Orders triangles in four passes: first those with three new vertices, then with two, one and none, so that batches
 * share few vertices.
 * @returns corners, three per triangle
 */
function orderOf(indices: Uint32Array): number[] {
	const met = new Set<number>();
	const ordered: number[] = [];
	let left = Array.from({ length: indices.length / 3 }, (_, t) => Array.from(indices.subarray(3 * t, 3 * t + 3)));
	for (const fresh of [3, 2, 1, 0]) {
		let turned = false;
		left = left.filter((corners) => {
			if (corners.filter((corner) => !met.has(corner)).length < fresh) return true;
			// Known vertices alternately first and last, so that new ones adjoin.
			ordered.push(...rotatedToKnown(corners, met, turned));
			turned = !turned;
			for (const corner of corners) met.add(corner);
			return false;
		});
	}
	return ordered;
}

/**
 * Rotates a triangle's corners so that those that were drawn before come first or, with `last`, last; returns them
 * unchanged where no rotation does.
 * @param met vertices that were drawn before
 */
function rotatedToKnown(corners: number[], met: ReadonlySet<number>, last: boolean): number[] {
	const turns = [0, 1, 2].map((k) => [...corners.slice(k), ...corners.slice(0, k)]);
	return turns.find((turn) => met.has(turn[last ? 2 : 0]) && !met.has(turn[last ? 0 : 2])) ?? corners;
}
