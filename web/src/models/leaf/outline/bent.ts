/**
 * Maps the flat outline to the leaf, which is folded along its midrib and curled: as bending.cpp of the core, without
 * waves and without rounding the crease. In leaf lengths.
 */
import type { HandleVector } from "../../../ui/handles/plant_handle";
import type { Place } from "./points";

/** Angles by which each half is raised, and by which the tip bends down over a leaf length, degrees. */
export interface Bend {
	readonly fold: number;
	readonly curl: number;
}

export interface BentPlace {
	readonly at: HandleVector;
	/** Unit tangents on the leaf as the flat point moves right and up; perpendicular. */
	readonly along: readonly [HandleVector, HandleVector];
	/** Ratio of the movement on the leaf to the upward movement of the flat point. */
	readonly stretch: number;
}

/** Largest angle that counts as no curl, degrees. */
const STRAIGHT = 0.05;
const RADIANS = Math.PI / 180;

/** Bends a place of the flat leaf as the core does: folded along the midrib, curled to a circular arc. */
export function bent({ x, y }: Place, { fold, curl }: Bend): BentPlace {
	const [rise, width] = [Math.sin(fold * RADIANS), Math.cos(fold * RADIANS)];
	const z = Math.abs(x) * rise;
	// On the midrib both sides have the same slope.
	const [acrossX, acrossZ] = x === 0 ? [1, 0] : [width, Math.sign(x) * rise];
	if (Math.abs(curl) < STRAIGHT) return { at: [x * width, y, z], along: [[acrossX, 0, acrossZ], [0, 1, 0]], stretch: 1 }; // biome-ignore format: two vectors
	const radius = 1 / (curl * RADIANS);
	const [sine, cosine] = [Math.sin(curl * RADIANS * y), Math.cos(curl * RADIANS * y)];
	return {
		at: [x * width, (radius + z) * sine, (radius + z) * cosine - radius],
		along: [
			[acrossX, acrossZ * sine, acrossZ * cosine],
			[0, cosine, -sine],
		],
		stretch: 1 + z / radius,
	};
}
