/** Describes a berry's place as seen by an observer, and orders berries from the top down. */

import { type Berries, TRAITS } from "../bunch_plant";
import { text } from "../messages.generated";

/** Share of a berry's distance from the axis below which a direction is not mentioned. */
const SLANT = 0.38;
/** Share of the widest distance from the axis below which a berry is inside. */
const INSIDE = 0.3;

/** Returns the indices of all berries, from the top of the bunch down. */
export function fromTheTop({ count, spheres }: Berries): number[] {
	return Array.from({ length: count }, (_, berry) => berry).sort((a, b) => spheres[4 * b + 1] - spheres[4 * a + 1]);
}

/**
 * Describes a berry's place, "at the top, front left": height in thirds of the bunch, direction as seen from the
 * front.
 */
export function placeInWords(berries: Berries, berry: number): string {
	let [top, bottom, widest] = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY, 0];
	for (let at = 0; at < 4 * berries.count; at += 4) {
		const [x, y, z] = berries.spheres.subarray(at, at + 3);
		top = Math.max(top, y);
		bottom = Math.min(bottom, y);
		widest = Math.max(widest, Math.hypot(x, z));
	}
	const [x, y, z] = berries.spheres.subarray(4 * berry, 4 * berry + 3);
	const height = ["top", "middle", "tip"][Math.min(2, Math.floor((3 * (top - y)) / (top - bottom || 1)))];
	return text("berry_place", { height, direction: directionOf(x, z, widest) });
}

/**
 * Returns the direction from the axis as a case of the message "berry_place": "front_left", or "inside".
 * @param widest greatest distance of a berry from the axis, metres
 */
function directionOf(x: number, z: number, widest: number): string {
	const distance = Math.hypot(x, z);
	if (distance < INSIDE * widest) return "inside";
	const words = [
		Math.abs(z) > SLANT * distance ? (z > 0 ? "front" : "back") : "",
		Math.abs(x) > SLANT * distance ? (x > 0 ? "right" : "left") : "",
	];
	return words.filter((word) => word !== "").join("_");
}

/** Returns a berry's width in millimetres, rounded: 18, 8.5. */
export function roundedWidth({ traits }: Berries, berry: number): number {
	const millimetres = traits[TRAITS.length * berry + TRAITS.indexOf("width")] * 1000;
	return millimetres < 10 ? Math.round(millimetres * 10) / 10 : Math.round(millimetres);
}
