/** Target and distance at which a camera shows a whole plant. */
export interface ViewFit {
	target: [x: number, y: number, z: number];
	distance: number;
	/** Radius of a sphere about the target that contains the plant. */
	radius: number;
	/** Radius of an upright cylinder about the target that contains the plant. */
	breadth: number;
}

/** Extent of a plant as spheres and points; metres. */
export interface Bodies {
	/** 4 × balls: centre, radius. */
	spheres: Float32Array;
	/** 3 × points. */
	points: Float32Array;
}

/** Surface of revolution about the plant's upright axis, as a stack of rings. */
export interface BoundingProfile {
	/** The upright axis midway between the plant's sides, and the height midway between its ends. */
	centre: [x: number, y: number, z: number];
	/** 3 × rings: distance from the axis, height over the centre, thickness (a ball's radius). */
	rings: Float32Array;
}

/** Angles about the axis at which a ring is tested. */
const TURNS = 24;
const AROUND = Array.from({ length: TURNS }, (_, turn) => {
	const angle = (2 * Math.PI * turn) / TURNS;
	return [Math.cos(angle), Math.sin(angle)] as const;
});

/** Above this number of bodies, only the outermost ring at each of `LEVELS` heights is stored. */
const MAX_RINGS = 2000;
const LEVELS = 400;

/**
 * Returns the bounding profile of a plant: its centre, and rings about the vertical axis that the camera must show.
 */
export function boundingProfileOf({ spheres, points }: Bodies): BoundingProfile {
	const low: BoundingProfile["centre"] = [Infinity, Infinity, Infinity];
	const high: BoundingProfile["centre"] = [-Infinity, -Infinity, -Infinity];
	extendBox(low, high, points, 3);
	extendBox(low, high, spheres, 4);
	if (!(low[0] <= high[0])) return { centre: [0, 0, 0], rings: new Float32Array([0.05, 0, 0]) };
	const centre: BoundingProfile["centre"] = [
		0.5 * (low[0] + high[0]),
		0.5 * (low[1] + high[1]),
		0.5 * (low[2] + high[2]),
	];
	const rings = new Float32Array((spheres.length / 4 + points.length / 3) * 3);
	const rest = writeRings(centre, spheres, 4, rings);
	writeRings(centre, points, 3, rest);
	return { centre, rings: outermost(rings, high[1] - low[1]) };
}

/** Returns the height of the lowest point of a profile, metres. */
export function lowestOf({ centre, rings }: BoundingProfile): number {
	let low = Infinity;
	for (let at = 0; at < rings.length; at += 3) low = Math.min(low, rings[at + 1] - rings[at + 2]);
	return centre[1] + low;
}

/**
 * Extends a box, in place, to contain points or spheres.
 * @param low corner with the least coordinates
 * @param high corner with the greatest coordinates
 * @param bodies `stride` numbers each: x y z, and with a stride of 4 the radius
 */
function extendBox(
	low: BoundingProfile["centre"],
	high: BoundingProfile["centre"],
	bodies: Float32Array,
	stride: 3 | 4,
): void {
	let [lowX, lowY, lowZ] = low;
	let [highX, highY, highZ] = high;
	for (let i = 0; i + stride <= bodies.length; i += stride) {
		const r = stride === 4 ? bodies[i + 3] : 0;
		lowX = Math.min(lowX, bodies[i] - r);
		lowY = Math.min(lowY, bodies[i + 1] - r);
		lowZ = Math.min(lowZ, bodies[i + 2] - r);
		highX = Math.max(highX, bodies[i] + r);
		highY = Math.max(highY, bodies[i + 1] + r);
		highZ = Math.max(highZ, bodies[i + 2] + r);
	}
	low.splice(0, 3, lowX, lowY, lowZ);
	high.splice(0, 3, highX, highY, highZ);
}

/**
 * Writes the ring that each point or sphere describes as the plant turns about its vertical axis: distance from the
 * axis, height over the centre, thickness.
 * @param bodies `stride` numbers each: x y z, and with a stride of 4 the radius
 * @returns the part of `rings` behind the last number written
 */
function writeRings(
	[x, y, z]: BoundingProfile["centre"],
	bodies: Float32Array,
	stride: 3 | 4,
	rings: Float32Array,
): Float32Array {
	let written = 0;
	for (let i = 0; i + stride <= bodies.length; i += stride) {
		const [dx, dz] = [bodies[i] - x, bodies[i + 2] - z];
		rings[written++] = Math.sqrt(dx * dx + dz * dz);
		rings[written++] = bodies[i + 1] - y;
		rings[written++] = stride === 4 ? bodies[i + 3] : 0;
	}
	return rings.subarray(written);
}

/**
 * Reduces very many rings to those that determine the plant's apparent size: at each height, the one that reaches
 * farthest out.
 */
function outermost(rings: Float32Array, height: number): Float32Array {
	if (rings.length <= 3 * MAX_RINGS) return rings;
	const outermostRing = new Int32Array(LEVELS + 1).fill(-1);
	const greatestReach = new Float32Array(LEVELS + 1).fill(-1);
	const perLevel = height > 0 ? LEVELS / height : 0;
	for (let i = 0; i < rings.length; i += 3) {
		const level = Math.min(LEVELS, Math.max(0, (rings[i + 1] * perLevel + 0.5 * LEVELS) | 0));
		const reach = rings[i] + rings[i + 2];
		if (reach > greatestReach[level]) {
			outermostRing[level] = i;
			greatestReach[level] = reach;
		}
	}
	const widest = outermostRing.filter((ring) => ring >= 0);
	const few = new Float32Array(3 * widest.length);
	widest.forEach((ring, k) => {
		few.set(rings.subarray(ring, ring + 3), 3 * k);
	});
	return few;
}

/**
 * Projection of a camera: vertical angle of view in radians, width over height, elevation over the target's horizon in
 * radians.
 */
export interface Lens {
	readonly fov: number;
	readonly aspect: number;
	readonly elevation: number;
}

/**
 * Returns the nearest distance from which the whole plant is visible from all sides.
 * @param fov vertical angle of view, radians
 * @param aspect width over height
 * @param margin share of the view's height and width that stays free on each side
 * @param elevation elevation of the camera over the target's horizon, radians
 */
export function fitView(
	profile: BoundingProfile,
	fov: number,
	aspect: number,
	margin: number,
	elevation: number,
): ViewFit {
	const { centre, rings } = profile;
	let radius = 0;
	let breadth = 0;
	for (let i = 0; i < rings.length; i += 3) {
		const [distanceFromAxis, height, thickness] = [rings[i], rings[i + 1], rings[i + 2]];
		radius = Math.max(radius, Math.hypot(distanceFromAxis, height) + thickness);
		breadth = Math.max(breadth, distanceFromAxis + thickness);
	}
	const distance = nearestWholeDistance(profile, centre, { fov, aspect, elevation }, margin);
	return { target: centre, distance, radius, breadth };
}

/** Returns whether a view fitted to another plant shows all of this one, from all sides. */
export function showsWhole(view: ViewFit, profile: BoundingProfile, lens: Lens): boolean {
	return nearestWholeDistance(profile, view.target, lens, 0) <= view.distance;
}

/**
 * Returns the nearest distance to a target from which a plant is completely visible from all sides: each ring is tested
 * at several angles about the axis, as seen by a camera at the lens's elevation.
 * @param margin share of the view's height and width that stays free on each side
 */
function nearestWholeDistance(
	{ centre, rings }: BoundingProfile,
	target: ViewFit["target"],
	lens: Lens,
	margin: number,
): number {
	const { fov, aspect, elevation } = lens;
	const halfHeight = Math.tan(fov / 2) * (1 - 2 * margin);
	const halfWidth = Math.tan(fov / 2) * aspect * (1 - 2 * margin);
	const sine = Math.sin(elevation);
	const cosine = Math.cos(elevation);
	const offset = Math.hypot(centre[0] - target[0], centre[2] - target[2]);
	const above = centre[1] - target[1];
	let distance = 1e-3;
	for (let i = 0; i < rings.length; i += 3) {
		const [distanceFromAxis, height, thickness] = [rings[i] + offset, rings[i + 1] + above, rings[i + 2]];
		for (const [turnCosine, turnSine] of AROUND) {
			const forwards = distanceFromAxis * turnCosine;
			const nearness = forwards * cosine + height * sine;
			const vertical = Math.abs(height * cosine - forwards * sine) + thickness;
			const horizontal = Math.abs(distanceFromAxis * turnSine) + thickness;
			distance = Math.max(distance, nearness + vertical / halfHeight, nearness + horizontal / halfWidth);
		}
	}
	return distance;
}

/**
 * Returns whether a plant has outgrown its view, shrunk to under 75 % of it, or moved by over a quarter of its radius.
 */
export function needsRefit(shown: ViewFit, now: ViewFit): boolean {
	const moved = Math.hypot(...now.target.map((value, k) => value - shown.target[k]));
	return hasOutgrown(shown, now) || now.distance < 0.75 * shown.distance || moved > 0.25 * shown.radius;
}

/** Returns whether a plant extends beyond its view: whether the fitting distance has grown by over 12 %. */
export function hasOutgrown(shown: ViewFit, now: ViewFit): boolean {
	return now.distance > 1.12 * shown.distance;
}
