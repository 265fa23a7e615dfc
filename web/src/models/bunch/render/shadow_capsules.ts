/** Shapes of a bunch that cast its shadow on the paper: berries, stems, and leaves as spheres. */
import type { Capsules } from "../../../render/capsule_shadow";
import { type BunchPlant, INTERNODE_KINDS } from "../bunch_plant";
import { halvesOf } from "../traits";
import { leafDiscs } from "./leaf_discs";

/**
 * Last kind of internode that casts among berries: only rachis and axes are visible, and the many short stems would
 * cost most.
 */
const SEEN_AMONG_BERRIES = INTERNODE_KINDS.indexOf("axis");

/**
 * Returns the shapes.
 * @param withBerries false for bare stems
 */
export function capsulesOf(grown: BunchPlant, withBerries: boolean): Capsules {
	const begins: number[] = [];
	const ends: number[] = [];
	if (withBerries) addBerries(grown, begins, ends);
	addStems(grown, withBerries ? SEEN_AMONG_BERRIES : INTERNODE_KINDS.length, begins, ends);
	const discs = grown.foliage ? leafDiscs(grown.foliage) : [];
	for (let i = 0; i < discs.length; i += 4) {
		begins.push(discs[i], discs[i + 1], discs[i + 2], discs[i + 3]);
		ends.push(discs[i], discs[i + 1], discs[i + 2]);
	}
	return { count: ends.length / 3, begins: Float32Array.from(begins), ends: Float32Array.from(ends) };
}

function addBerries({ berries }: BunchPlant, begins: number[], ends: number[]): void {
	for (let i = 0; i < berries.count; i++) {
		const [width, length] = halvesOf(berries, i);
		const reach = Math.max(0, length - width);
		for (let k = 0; k < 3; k++) {
			const along = reach * berries.directions[3 * i + k];
			begins.push(berries.spheres[4 * i + k] - along);
			ends.push(berries.spheres[4 * i + k] + along);
		}
		begins.push(width);
	}
}

/**
 * Adds stems.
 * @param last kind of internode that casts
 */
function addStems({ internodes }: BunchPlant, last: number, begins: number[], ends: number[]): void {
	const { count, kind, radii } = internodes;
	for (let i = 0; i < count; i++) {
		if (kind[i] > last) continue;
		begins.push(...internodes.ends.subarray(6 * i, 6 * i + 3), 0.5 * (radii[2 * i] + radii[2 * i + 1]));
		ends.push(...internodes.ends.subarray(6 * i + 3, 6 * i + 6));
	}
}
