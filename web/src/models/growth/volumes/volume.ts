/**
 * A growth volume, the solid of revolution that limits a tree's branches (Kim, Kim and Cho 2013, section 3.3): a
 * leaning quadric through the circles of its widths at the base, halfway up and at the top. Pure maths.
 */

export type GrowthTriple = readonly [x: number, y: number, z: number];

export interface GrowthVolume {
	readonly id: number;
	/** Widths and height along its axis, metres: `wb`, `h`, `wt`. */
	readonly base: number;
	readonly height: number;
	readonly top: number;
	/** Width halfway up, metres: `wm`; the mean of the others for a frustum. */
	readonly middle: number;
	/** Lean of its axis, degrees: `grad`. */
	readonly gradient: number;
	/** Direction of lean, degrees from +X to +Z. */
	readonly towards: number;
	/** Position on the ground, metres. */
	readonly at: readonly [x: number, z: number];
}

/** Limits of the sizes that users can set, metres; the core allows the same and more (models/growth/volumes.cpp). */
export const LOWEST = 0.5;
export const HIGHEST = 100;
export const WIDEST = 100;

/** Converts degrees to radians. */
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Returns a volume's axis, a unit vector. */
export function axisOf({ gradient, towards }: Pick<GrowthVolume, "gradient" | "towards">): GrowthTriple {
	const [horizontal, angle] = [Math.sin(radians(gradient)), radians(towards)];
	return [horizontal * Math.cos(angle), Math.cos(radians(gradient)), horizontal * Math.sin(angle)];
}

/** Returns the direction in which widths are shown: perpendicular to the axis and to the direction of lean. */
export function acrossOf({ towards }: Pick<GrowthVolume, "towards">): GrowthTriple {
	const angle = radians(towards);
	return [-Math.sin(angle) + 0, 0, Math.cos(angle)];
}

/** Returns a point of a volume: at a share of its height, `distance` metres from its axis, `degrees` from `acrossOf`. */
export function placeIn(volume: GrowthVolume, share: number, distance = 0, degrees = 0): GrowthTriple {
	const axis = axisOf(volume);
	const firstDirection = acrossOf(volume);
	const secondDirection: GrowthTriple = [
		firstDirection[1] * axis[2] - firstDirection[2] * axis[1],
		firstDirection[2] * axis[0] - firstDirection[0] * axis[2],
		firstDirection[0] * axis[1] - firstDirection[1] * axis[0],
	];
	const [height, cosine, sine] = [
		share * volume.height,
		distance * Math.cos(radians(degrees)),
		distance * Math.sin(radians(degrees)),
	];
	const foot: GrowthTriple = [volume.at[0], 0, volume.at[1]];
	return [0, 1, 2].map(
		(k) => foot[k] + height * axis[k] + cosine * firstDirection[k] + sine * secondDirection[k],
	) as unknown as GrowthTriple;
}

/** Returns a frustum's width halfway up, to the centimetre. */
export const meanWidth = (base: number, top: number): number => Math.round(50 * (base + top)) / 100;

/**
 * Returns the radius at a share of the height. Its square is the quadratic through the squares of the three radii
 * (Lagrange's formula), which for a frustum is that of a straight line.
 * @param up share of the height, 0 at the base
 */
export function radiusAt({ base, middle, top }: Pick<GrowthVolume, "base" | "middle" | "top">, up: number): number {
	const square = base ** 2 * (1 - up) * (1 - 2 * up) + middle ** 2 * 4 * up * (1 - up) + top ** 2 * up * (2 * up - 1);
	return 0.5 * Math.sqrt(Math.max(0, square));
}

const SIDES = 32;
/** Shares of the height with rings: closer towards the ends, where a dome curves. */
const HEIGHTS = Array.from({ length: 15 }, (_, i) => (1 - Math.cos((Math.PI * i) / 14)) / 2);

/** Returns a volume's surface, for the view. */
export function surfaceOf(volume: GrowthVolume): { points: number[]; triangles: number[] } {
	const rings: [up: number, out: number][] = [
		[0, 0],
		...HEIGHTS.map((up): [number, number] => [up, radiusAt(volume, up)]),
		[1, 0],
	];
	const points = rings.flatMap(([up, out]) =>
		Array.from({ length: SIDES }, (_, i) => placeIn(volume, up, out, (360 * i) / SIDES)).flat(),
	);
	return { points, triangles: TRIANGLES };
}

/** Triangles of every volume, one shared array: the view recognises by it a body that was only stretched. */
const TRIANGLES = Array.from({ length: HEIGHTS.length + 1 }, (_, ring) => ring).flatMap((ring) =>
	Array.from({ length: SIDES }, (_, i) => {
		const [a, b] = [ring * SIDES + i, ring * SIDES + ((i + 1) % SIDES)];
		return [a, b + SIDES, b, a, a + SIDES, b + SIDES];
	}).flat(),
);
