/** The crown of a tree as a volume: leaves on its outside face outwards, so that their shading shows its shape. */
import type { Vector } from "./part";
import type { Plant } from "./plant";

/** An upright ellipsoid about the leaves. */
export interface Crown {
	readonly centre: Vector;
	/** Half of its width and of its height, metres. */
	readonly breadth: number;
	readonly height: number;
}

/** Share of the crown's outward direction in a leaf's shading normal. */
export const BEND = 0.5;

/** Factor on the standard deviation of the leaves' positions: half the size of an even ball is √5 times that. */
const SIZE = Math.sqrt(5);

/** Returns the ellipsoid with the leaves' mean position and spread; undefined for fewer than three leaves. */
export function crownOf({ organs }: Pick<Plant, "organs">): Crown | undefined {
	const { transforms, count } = organs;
	if (count < 3) return undefined;
	const sums = [0, 0, 0];
	const squares = [0, 0, 0];
	for (let i = 0; i < count; i++)
		for (let k = 0; k < 3; k++) {
			const value = transforms[8 * i + k];
			sums[k] += value;
			squares[k] += value * value;
		}
	const centre = sums.map((sum) => sum / count) as Vector;
	const variance = squares.map((square, k) => Math.max(0, square / count - centre[k] ** 2));
	const breadth = SIZE * Math.sqrt(0.5 * (variance[0] + variance[2]));
	return { centre, breadth: Math.max(breadth, 1e-6), height: Math.max(SIZE * Math.sqrt(variance[1]), 1e-6) };
}

/** Returns the outward direction of the crown at a point: the ellipsoid's normal; up at its centre. */
export function outwards({ centre, breadth, height }: Crown, [x, y, z]: Vector): Vector {
	const d: Vector = [(x - centre[0]) / breadth ** 2, (y - centre[1]) / height ** 2, (z - centre[2]) / breadth ** 2];
	const length = Math.hypot(...d);
	return length > 0 ? [d[0] / length, d[1] / length, d[2] / length] : [0, 1, 0];
}

/**
 * Returns the shading normal of a leaf at a point of the crown, in the plant's frame: its own normal, bent outwards by
 * `BEND`.
 */
export function bentNormal(crown: Crown, point: Vector, normal: Vector): Vector {
	const out = outwards(crown, point);
	const bent = normal.map((value, k) => value + BEND * (out[k] - value)) as Vector;
	const length = Math.hypot(...bent) || 1;
	return [bent[0] / length, bent[1] / length, bent[2] / length];
}
