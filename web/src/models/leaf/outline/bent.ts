/**
 * Where the flat outline lies on the leaf, which is folded along its midrib and curled: bending.cpp of the core without waves and the
 * roundness of the crease. In lengths of the leaf.
 */
import type { Vector } from "../../../ui/handles/plant_handle";
import type { Place } from "./points";

/** Degrees that each half is raised by, and that the tip is turned down by along a length. */
export interface Bend {
	readonly fold: number;
	readonly curl: number;
}

export interface BentPlace {
	readonly at: Vector;
	/** Where that goes as the flat place goes to the right and up: of length 1, at right angles. */
	readonly along: readonly [Vector, Vector];
	/** How far it goes up for each bit that the flat place does. */
	readonly stretch: number;
}

/** Degrees that are no curl. */
const STRAIGHT = 0.05;
const RADIANS = Math.PI / 180;

export function bent({ x, y }: Place, { fold, curl }: Bend): BentPlace {
	const [rise, reach] = [Math.sin(fold * RADIANS), Math.cos(fold * RADIANS)];
	const z = Math.abs(x) * rise;
	// In the middle both sides are as steep.
	const [out, up] = x === 0 ? [1, 0] : [reach, Math.sign(x) * rise];
	if (Math.abs(curl) < STRAIGHT) return { at: [x * reach, y, z], along: [[out, 0, up], [0, 1, 0]], stretch: 1 }; // biome-ignore format: two vectors
	const radius = 1 / (curl * RADIANS);
	const [sine, cosine] = [Math.sin(curl * RADIANS * y), Math.cos(curl * RADIANS * y)];
	return {
		at: [x * reach, (radius + z) * sine, (radius + z) * cosine - radius],
		along: [
			[out, up * sine, up * cosine],
			[0, cosine, -sine],
		],
		stretch: 1 + z / radius,
	};
}
