/**
 * How a calm wind moves a plant: a place of it by where it is, so that whatever touches stays together, whosever mesh it is in; what
 * is held by its foot (a leaf) goes with that, and turns a little about it. All in one beat, so that a sine and a cosine of time
 * say all. Here is what of it is a plant's own; the view's shader (render/wind.ts) and files (swing.ts) move a place by that.
 */
import type { Vector } from "./part";
import type { Plant } from "./plant";

/** Seconds until everything is again where it was. */
export const BEAT = 5;
/** How far the top goes, as a share of the height; branches' ends beyond that, of how far they reach. */
export const TRUNK = 0.022;
export const BRANCH = 0.012;
/** By how much a leaf turns about its foot, radians. */
export const LEAF = 0.1;
/** How much later the wind comes from end to end of a plant, and by how much leaves beside each other differ, radians. */
export const WAVE = 3;
export const FLUTTER = 60;

/** What of a plant says how it moves. */
export interface Sway {
	/** What stands still: where its first segment begins, as high as the lowest that no other bears; of what hangs, the highest. */
	readonly foot: Vector;
	/** 1 of what stands, −1 of what hangs. */
	readonly up: 1 | -1;
	/** From the foot to the top and from the axis to the farthest end, metres; more than 0. */
	readonly height: number;
	readonly reach: number;
}

/** Undefined of a plant without extent. */
export function swayOf({ segments, organs }: Pick<Plant, "segments" | "organs">): Sway | undefined {
	const { ends, parent, count } = segments;
	if (count === 0) return undefined;
	const [x, first, z] = ends;
	let [low, high, reach] = [first, first, 0];
	const hold = (at: ArrayLike<number>, i: number) => {
		low = Math.min(low, at[i + 1]);
		high = Math.max(high, at[i + 1]);
		reach = Math.max(reach, Math.hypot(at[i] - x, at[i + 2] - z));
	};
	for (let i = 0; i < ends.length; i += 3) hold(ends, i);
	for (let i = 0; i < organs.transforms.length; i += 8) hold(organs.transforms, i);
	const up = high - first >= first - low ? 1 : -1;
	let foot = first;
	for (let i = 0; i < count; i++) if (parent[i] < 0) foot = up * Math.min(up * foot, up * ends[6 * i + 1]);
	const height = up > 0 ? high - foot : foot - low;
	return height > 0 ? { foot: [x, foot, z], up, height, reach: Math.max(reach, 1e-6 * height) } : undefined;
}
