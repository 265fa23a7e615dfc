/** Triangles looked at together. Software draws 128 at a time and keeps 64 vertices meanwhile; these have about as many. */
const TOGETHER = 64;

/**
 * The same triangles in an order in which vertices that have not been met follow each other, first three a triangle, then
 * two, then one. Software works vertices out by fours of the list from the first it has not kept: of neighbouring
 * triangles most of the four are the same again.
 * @param indices 3 × triangles
 */
export function triangleOrder(indices: Uint32Array): Uint32Array {
	const ordered = new Uint32Array(indices.length);
	for (let first = 0; first < indices.length; first += 3 * TOGETHER) {
		ordered.set(orderOf(indices.subarray(first, first + 3 * TOGETHER)), first);
	}
	return ordered;
}

function orderOf(indices: Uint32Array): number[] {
	const met = new Set<number>();
	const ordered: number[] = [];
	let left = Array.from({ length: indices.length / 3 }, (_, t) => Array.from(indices.subarray(3 * t, 3 * t + 3)));
	for (const fresh of [3, 2, 1, 0]) {
		let turned = false;
		left = left.filter((corners) => {
			if (corners.filter((corner) => !met.has(corner)).length < fresh) return true;
			// Old ones first and old ones last by turns, so that fresh ones meet.
			ordered.push(...fromOld(corners, met, turned));
			turned = !turned;
			for (const corner of corners) met.add(corner);
			return false;
		});
	}
	return ordered;
}

/** A triangle's corners, round the same way, with those that have been met first, or last. */
function fromOld(corners: number[], met: ReadonlySet<number>, last: boolean): number[] {
	const turns = [0, 1, 2].map((k) => [...corners.slice(k), ...corners.slice(0, k)]);
	return turns.find((turn) => met.has(turn[last ? 2 : 0]) && !met.has(turn[last ? 0 : 2])) ?? corners;
}
