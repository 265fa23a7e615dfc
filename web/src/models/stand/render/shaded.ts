/** The part of a stand that casts shadows: all of it or, for a walker, the surroundings at a finer resolution. Pure. */
import { Vector3 } from "three";
import { heightAt } from "../ground_grid";
import type { StandPlant } from "../stand_plant";
import { eyeHeight } from "../walker";

export interface StandBall {
	readonly centre: Vector3;
	readonly radius: number;
}

/** Radius of the shaded sphere around a walker, in eye heights, and the offset of its centre ahead, in radii. */
const REACH = 24;
const AHEAD = 0.6;
/** Steps per radius: shadows are redrawn with each step. */
const STEPS = 4;
/** Greatest height over the ground that counts as walking, in eye heights. */
const HIGHEST = 3;

/** Returns whether a camera is where a walker's eyes could be: over the ground and not much above it. */
export function isWalking(stand: Pick<StandPlant, "ground" | "meshes">, eye: Vector3): boolean {
	const { width, depth } = stand.ground;
	if (Math.abs(eye.x) > 0.5 * width || Math.abs(eye.z) > 0.5 * depth) return false;
	return eye.y - heightAt(stand, eye.x, eye.z) <= HIGHEST * eyeHeight(stand);
}

/**
 * Returns the bounding sphere of the part that casts shadows; before a walker it moves in steps, so that shadows rarely
 * change.
 * @param whole bounding sphere of the stand
 * @param eye camera position, metres
 * @param towards view direction, a unit vector
 */
export function shadedBall(
	stand: Pick<StandPlant, "ground" | "meshes">,
	whole: StandBall,
	eye: Vector3,
	towards: Vector3,
): StandBall {
	const radius = REACH * eyeHeight(stand);
	if (radius >= whole.radius || !isWalking(stand, eye)) return whole;
	const step = radius / STEPS;
	const toStep = (value: number) => step * Math.round(value / step);
	const [x, z] = [eye.x + AHEAD * radius * towards.x, eye.z + AHEAD * radius * towards.z].map(toStep);
	return { centre: new Vector3(x, toStep(heightAt(stand, eye.x, eye.z)), z), radius };
}
