import type { Side } from "./materials";

/** Texture coordinates of the chart (u right, v to the tip, from above) as each face is seen, tip up: u right, v down. */
export function asSeen(uvs: Float32Array, side: Side): Float32Array {
	return uvs.map((value, at) => (at % 2 === 0 && side === "upper" ? value : 1 - value));
}
