import type { Side } from "./materials";

/**
 * Converts texture coordinates of the chart (u right, v to the tip, from above) to those of a face seen from its side,
 * tip up: u right, v down.
 */
export function asSeen(uvs: Float32Array, side: Side): Float32Array {
	return uvs.map((value, at) => (at % 2 === 0 && side === "upper" ? value : 1 - value));
}
