/** Branches of a plant: which limb's side branch each segment belongs to. */
import type { Plant } from "./plant";

/** Segments thicker than this share of the thickest one belong to the trunk and its limbs. */
const LIMB = 0.2;

/**
 * Returns for each segment the first segment of its branch: the farthest ancestor, or itself, that is thinner than the
 * trunk and the limbs; −1 for those.
 */
export function branchBases({ parent, radii, count }: Plant["segments"]): Int32Array {
	let thickest = 0;
	for (let i = 0; i < count; i++) thickest = Math.max(thickest, radii[2 * i]);
	const limit = LIMB * thickest;
	const UNKNOWN = -2;
	const bases = new Int32Array(count).fill(UNKNOWN);
	const path: number[] = [];
	for (let start = 0; start < count; start++) {
		let at = start;
		path.length = 0;
		while (at >= 0 && bases[at] === UNKNOWN) {
			path.push(at);
			at = parent[at];
		}
		let base = at >= 0 ? bases[at] : -1;
		for (let i = path.length - 1; i >= 0; i--) {
			const segment = path[i];
			if (base < 0 && radii[2 * segment] < limit) base = segment;
			bases[segment] = base;
		}
	}
	return bases;
}
