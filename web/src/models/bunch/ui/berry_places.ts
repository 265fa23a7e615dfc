/** Describes a berry's place as seen by an observer, and orders berries from the top down. */
import { type Berries, TRAITS } from "../bunch_plant";

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
	const height = ["at the top", "in the middle", "at the tip"][
		Math.min(2, Math.floor((3 * (top - y)) / (top - bottom || 1)))
	];
	return `${height}, ${directionInWords(x, z, widest)}`;
}

function directionInWords(x: number, z: number, widest: number): string {
	const away = Math.hypot(x, z);
	if (away < INSIDE * widest) return "inside";
	const words = [
		Math.abs(z) > SLANT * away ? (z > 0 ? "front" : "back") : "",
		Math.abs(x) > SLANT * away ? (x > 0 ? "right" : "left") : "",
	];
	return words.filter((word) => word !== "").join(" ");
}

/** Describes a berry's width: "18 mm", "8.5 mm". */
export function widthInWords({ traits }: Berries, berry: number): string {
	const millimetres = traits[TRAITS.length * berry + TRAITS.indexOf("width")] * 1000;
	return `${millimetres < 10 ? Math.round(millimetres * 10) / 10 : Math.round(millimetres)} mm`;
}
