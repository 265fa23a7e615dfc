/** Shapes of a bunch that cast its shadow on the paper: berries, stems, and leaves as spheres. */
import type { Capsules } from "../../../render/capsule_shadow";
import { type BunchPlant, type Foliage, INTERNODE_KINDS } from "../bunch_plant";
import { halvesOf } from "../traits";
import { leafDiscs } from "./leaf_discs";

/**
 * Last kind of internode that casts a shadow when berries are shown: of a full bunch, only rachis and axes are visible,
 * and the many short stems would cost most.
 */
const LAST_KIND_AMONG_BERRIES = INTERNODE_KINDS.indexOf("axis");
const LAST_KIND = INTERNODE_KINDS.length - 1;

/**
 * Returns one capsule per berry and per internode, in metres. A leaf becomes several spheres: capsules whose axis has
 * length 0. A capsule has 4 numbers in `begins` (x, y, z of the axis' start, and the radius) and 3 in `ends` (x, y, z
 * of the axis' end).
 * @param withBerries false for bare stems, all of which then cast a shadow
 */
export function capsulesOf(grown: BunchPlant, withBerries: boolean): Capsules {
	const begins: number[] = [];
	const ends: number[] = [];
	if (withBerries) addBerries(grown, begins, ends);
	addStems(grown, withBerries ? LAST_KIND_AMONG_BERRIES : LAST_KIND, begins, ends);
	if (grown.foliage) addLeaves(grown.foliage, begins, ends);
	return { count: ends.length / 3, begins: Float32Array.from(begins), ends: Float32Array.from(ends) };
}

/** Adds a capsule per berry, along its axis: long berries cast long shadows. */
function addBerries({ berries }: BunchPlant, begins: number[], ends: number[]): void {
	for (let i = 0; i < berries.count; i++) {
		const [width, length] = halvesOf(berries, i);
		const halfAxis = Math.max(0, length - width);
		for (let k = 0; k < 3; k++) {
			const offset = halfAxis * berries.directions[3 * i + k];
			begins.push(berries.spheres[4 * i + k] - offset);
			ends.push(berries.spheres[4 * i + k] + offset);
		}
		begins.push(width);
	}
}

/**
 * Adds a capsule per internode, with the mean of the radii at its ends.
 * @param lastKind code of the last kind of internode (`INTERNODE_KINDS`) that casts a shadow
 */
function addStems({ internodes }: BunchPlant, lastKind: number, begins: number[], ends: number[]): void {
	const { count, kind, radii } = internodes;
	for (let i = 0; i < count; i++) {
		if (kind[i] > lastKind) continue;
		begins.push(...internodes.ends.subarray(6 * i, 6 * i + 3), 0.5 * (radii[2 * i] + radii[2 * i + 1]));
		ends.push(...internodes.ends.subarray(6 * i + 3, 6 * i + 6));
	}
}

/** Adds the spheres that approximate leaves, as capsules of length 0. */
function addLeaves(foliage: Foliage, begins: number[], ends: number[]): void {
	const discs = leafDiscs(foliage);
	for (let i = 0; i < discs.length; i += 4) {
		const [x, y, z, radius] = discs.subarray(i, i + 4);
		begins.push(x, y, z, radius);
		ends.push(x, y, z);
	}
}
