/** How a plant stands on level ground: for the ground, the shadow at its foot, and the height of the eye. */
import type { Vector } from "./part";
import type { Plant } from "./plant";

/** A stem at the ground, seen as an upright cylinder. */
export interface StandingStem {
	readonly x: number;
	readonly z: number;
	readonly radius: number;
}

export interface Footing {
	/** The middle of the stems at the ground, metres. */
	readonly centre: Vector;
	/** The stems at the ground, thickest first; at most `MAX_STEMS`. */
	readonly stems: readonly StandingStem[];
	/** Greatest horizontal distance of the plant from its centre, and its height over the ground, metres. */
	readonly reach: number;
	readonly height: number;
	/** Share of the sky that the crown hides from the ground below it, 0 … 1. */
	readonly cover: number;
}

export const MAX_STEMS = 6;

/** Share of the height up to which segments without a parent start at the ground. */
const AT_GROUND = 0.05;
/** Width of a root flare as a factor on the radius of its stem. */
const FLARE = 1.25;
/** Extinction of light in a crown, per leaf area over ground area (Beer's law; Bréda 2003). */
const EXTINCTION = 0.5;
/** Area of a leaf or of a twig of leaves of unit size, as a share of the square of its size. */
const LEAF_SHARE = 0.5;

/** Returns how a plant stands; undefined for a plant without stems, or one that grows downwards. */
export function footingOf({ segments, organs }: Pick<Plant, "segments" | "organs">): Footing | undefined {
	const { ends, radii, parent, count } = segments;
	if (count === 0) return undefined;
	const level = lowestStart(segments);
	let top = level;
	for (let i = 1; i < ends.length; i += 3) top = Math.max(top, ends[i]);
	for (let i = 1; i < organs.transforms.length; i += 8) top = Math.max(top, organs.transforms[i]);
	const height = top - level;
	if (!(height > 0) || ends[1] - level > 0.5 * height) return undefined;
	const stems: StandingStem[] = [];
	for (let i = 0; i < count; i++)
		if (parent[i] < 0 && ends[6 * i + 1] - level <= AT_GROUND * height)
			stems.push({ x: ends[6 * i], z: ends[6 * i + 2], radius: FLARE * radii[2 * i] });
	stems.sort((one, other) => other.radius - one.radius);
	stems.length = Math.min(stems.length, MAX_STEMS);
	const middle = (axis: "x" | "z") => stems.reduce((sum, stem) => sum + stem[axis], 0) / stems.length;
	const centre: Vector = [middle("x"), level, middle("z")];
	let [reach, leaves] = [0, 0];
	for (let i = 0; i < ends.length; i += 3)
		reach = Math.max(reach, Math.hypot(ends[i] - centre[0], ends[i + 2] - centre[2]));
	for (let i = 7; i < organs.transforms.length; i += 8)
		if (organs.transforms[i - 6] - level > AT_GROUND * height) leaves += LEAF_SHARE * organs.transforms[i] ** 2;
	const cover = reach > 0 ? 1 - Math.exp((-EXTINCTION * leaves) / (Math.PI * reach * reach)) : 0;
	return { centre, stems, reach: Math.max(reach, 0.02 * height), height, cover };
}

/** Returns the least height at which a segment without a parent starts, metres. */
function lowestStart({ ends, parent, count }: Plant["segments"]): number {
	let level = Number.POSITIVE_INFINITY;
	for (let i = 0; i < count; i++) if (parent[i] < 0) level = Math.min(level, ends[6 * i + 1]);
	return level;
}

/**
 * Returns the share of the sky that is visible from the ground at a distance from a stem, weighted by the cosine to the
 * vertical: a tall cylinder of radius r at distance d hides the directions within asin(r / d) of its own.
 */
export function openBesideStem(radius: number, distance: number): number {
	return 1 - Math.asin(Math.min(1, radius / Math.max(distance, 1e-9))) / Math.PI;
}
