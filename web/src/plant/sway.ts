/**
 * Motion of a plant in calm wind. A point's motion depends on its position, so that touching parts stay together, in
 * any mesh; parts with a fixed point (leaves) move with it, and turn a little about it. All motion has
 * one period, so that a sine and a cosine of time describe it. This file has the numbers of a plant; the view's shader
 * (render/wind_shader.ts) and files (point_sway.ts) move points by them.
 */
import type { Vector } from "./part";
import type { Plant } from "./plant";

/** The period in seconds. */
export const PERIOD = 5;
/** Amplitude of the top as a share of the height; ends of branches move further, by a share of their reach. */
export const TOP_AMPLITUDE = 0.022;
export const BRANCH = 0.012;
/** The angle by which a leaf turns about its fixed point, radians. */
export const LEAF_ANGLE = 0.1;
/** Phase lag of the wind from end to end of a plant, and phase difference between neighbouring leaves, radians. */
export const PHASE_LAGS = 3;
export const FLUTTER = 60;

/** The numbers of a plant's motion. */
export interface Sway {
	/**
	 * The point that does not move: the start of the first segment, at the height of the lowest segment without a
	 * parent; for hanging plants, of the highest.
	 */
	readonly foot: Vector;
	/** 1 for standing plants, −1 for hanging ones. */
	readonly up: 1 | -1;
	/** From the fixed point to the top, and from the axis to the farthest end, metres; above 0. */
	readonly height: number;
	readonly reach: number;
}

/**
 * Computes how a plant sways in wind: its fixed point, direction, height and horizontal reach. Undefined for a plant
 * without height.
 */
export function swayOf({ segments, organs }: Pick<Plant, "segments" | "organs">): Sway | undefined {
	const { ends, parent, count } = segments;
	if (count === 0) return undefined;
	const [x, first, z] = ends;
	let [low, high, reach] = [first, first, 0];
	// Extends the bounds by the point whose x is at index i.
	const extend = (at: ArrayLike<number>, i: number) => {
		low = Math.min(low, at[i + 1]);
		high = Math.max(high, at[i + 1]);
		reach = Math.max(reach, Math.hypot(at[i] - x, at[i + 2] - z));
	};
	for (let i = 0; i < ends.length; i += 3) extend(ends, i);
	for (let i = 0; i < organs.transforms.length; i += 8) extend(organs.transforms, i);
	const up = high - first >= first - low ? 1 : -1;
	let foot = first;
	for (let i = 0; i < count; i++) if (parent[i] < 0) foot = up * Math.min(up * foot, up * ends[6 * i + 1]);
	const height = up > 0 ? high - foot : foot - low;
	return height > 0 ? { foot: [x, foot, z], up, height, reach: Math.max(reach, 1e-6 * height) } : undefined;
}
