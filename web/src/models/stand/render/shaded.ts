/** What of a stand has its shadows drawn: all of it, and for who walks in it what is about them, so much the finer. Pure. */
import { Vector3 } from "three";
import { heightAt } from "../ground_grid";
import type { StandPlant } from "../stand_plant";
import { eyeHeight } from "../walker";

export interface Ball {
	readonly centre: Vector3;
	readonly radius: number;
}

/** How far shadows reach about a walker, eyes' heights, and how far ahead of them their middle is, of that. */
const REACH = 24;
const AHEAD = 0.6;
/** So many steps to a reach: shadows are drawn again with each. */
const STEPS = 4;
/** Who stands no higher over the ground walks, eyes' heights. */
const HIGHEST = 3;

/** Whether an eye is where that of who walks there is. */
export function walks(stand: Pick<StandPlant, "ground" | "meshes">, eye: Vector3): boolean {
	const { width, depth } = stand.ground;
	if (Math.abs(eye.x) > 0.5 * width || Math.abs(eye.z) > 0.5 * depth) return false;
	return eye.y - heightAt(stand, eye.x, eye.z) <= HIGHEST * eyeHeight(stand);
}

/**
 * @param whole what holds the stand
 * @param eye where it is seen from, metres
 * @param towards which way, of length 1
 */
export function shadedBall(
	stand: Pick<StandPlant, "ground" | "meshes">,
	whole: Ball,
	eye: Vector3,
	towards: Vector3,
): Ball {
	const radius = REACH * eyeHeight(stand);
	if (radius >= whole.radius || !walks(stand, eye)) return whole;
	const step = radius / STEPS;
	const stepped = (value: number) => step * Math.round(value / step);
	const [x, z] = [eye.x + AHEAD * radius * towards.x, eye.z + AHEAD * radius * towards.z].map(stepped);
	return { centre: new Vector3(x, stepped(heightAt(stand, eye.x, eye.z)), z), radius };
}
