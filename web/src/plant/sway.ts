/**
 * How a calm wind moves a plant: a place of it by where it is, so that whatever touches stays together, whosever mesh it is in; what
 * is held by its foot (a leaf) goes with that, and turns a little about it. All in one beat, so that a sine and a cosine of time
 * say all: the view's shader (scene/wind.ts) and the animation in files are this function.
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

/** Where a place is at a time: so much times the sine and so much times the cosine of the time's angle from where it stands. */
export interface Swing {
	readonly sine: Vector;
	readonly cosine: Vector;
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

const clamped = (value: number) => Math.min(1, Math.max(0, value));

/**
 * How a place swings.
 * @param held where what it belongs to is held, of what is held by a foot; else the place itself
 */
export function swing({ foot, up, height, reach }: Sway, place: Vector, held: Vector = place): Swing {
	const [dx, dy, dz] = [held[0] - foot[0], held[1] - foot[1], held[2] - foot[2]];
	const h = clamped((up * dy) / height);
	const r = clamped(Math.hypot(dx, dz) / reach);
	const bend = TRUNK * height * h * h * (1.5 - 0.5 * h);
	const bob = BRANCH * reach * r * r * h * (2 - h);
	const size = Math.max(height, reach);
	const late = (WAVE * (0.8 * dx + 0.5 * dy + 0.6 * dz)) / size;
	const [c, s] = [bob * Math.cos(late), bob * Math.sin(late)];
	const own = (FLUTTER * (held[0] + 1.7 * held[1] + 2.3 * held[2])) / size;
	// What has fallen lies still.
	const turns = LEAF * Math.min(1, 8 * h);
	const [lc, ls] = [turns * Math.cos(own), turns * Math.sin(own)];
	// About the horizontal axis across the wind.
	const [ox, oy, oz] = [place[0] - held[0], place[1] - held[1], place[2] - held[2]];
	const turn: Vector = [-0.8 * oy, 0.8 * ox + 0.6 * oz, -0.6 * oy];
	const along = bend + c;
	const across = 0.4 * bend + 0.5 * c;
	return {
		sine: [0.8 * along - 0.3 * s + lc * turn[0], 0.6 * c + lc * turn[1], 0.6 * along + 0.4 * s + lc * turn[2]],
		cosine: [-0.8 * s - 0.6 * across - ls * turn[0], -0.6 * s - ls * turn[1], -0.6 * s + 0.8 * across - ls * turn[2]],
	};
}
