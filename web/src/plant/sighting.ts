/** Picking: the first segment or organ that a ray meets. */
import { type DrawnGeometry, type DrawnSurface, trianglesOf } from "./drawn";

/** A ray, in metres. */
export interface Ray {
	readonly origin: ArrayLike<number>;
	/** Of any length. */
	readonly direction: ArrayLike<number>;
}

/** The first hit: a segment or an organ. */
export interface RayHit {
	readonly segment?: number;
	readonly organ?: number;
}

/** A bounding sphere of an organ. */
interface BoundingSphere {
	readonly x: number;
	readonly y: number;
	readonly z: number;
	readonly radius: number;
}

/**
 * Bounding spheres, made on first use. Triangles are not cached: those of many thousands of organs take hundreds of
 * megabytes.
 */
const known = new WeakMap<DrawnGeometry, (BoundingSphere | undefined)[]>();

/**
 * Returns the first hit of a ray.
 * @param slack tolerance for segments per unit of distance: thin ones are hard to hit
 */
export function castRay(drawn: DrawnGeometry, { origin, direction }: Ray, slack: number): RayHit | undefined {
	const length = Math.hypot(direction[0], direction[1], direction[2]);
	const along = [direction[0] / length, direction[1] / length, direction[2] / length] as const;
	let [nearest, found] = [Number.POSITIVE_INFINITY, undefined as RayHit | undefined];
	ballsOf(drawn).forEach((ball, index) => {
		if (!ball || !hitsSphere(ball, origin, along, nearest)) return;
		const surface = drawn.surface(index);
		const at = surface && hitTriangles(trianglesOf(surface), origin, along, nearest);
		if (at !== undefined) [nearest, found] = [at, { organ: index }];
	});
	for (let segment = 0; segment < drawn.radii.length / 2; segment++) {
		const at = hitSegment(drawn, segment, origin, along, slack);
		if (at !== undefined && at < nearest) [nearest, found] = [at, { segment }];
	}
	return found;
}

/** Returns a bounding sphere for each drawn organ, cached by geometry. */
function ballsOf(drawn: DrawnGeometry): (BoundingSphere | undefined)[] {
	let balls = known.get(drawn);
	if (!balls) {
		// Bounding spheres of meshes that several organs share, before their transforms.
		const shared = new Map<Float32Array, BoundingSphere | undefined>();
		balls = Array.from({ length: drawn.organs }, (_, index) => {
			const surface = drawn.surface(index);
			if (!surface) return undefined;
			const { positions, transform, run } = surface;
			if (run) return ballAbout(trianglesOf(surface));
			if (!shared.has(positions)) shared.set(positions, ballAbout(trianglesOf({ ...surface, transform: undefined })));
			return transformedSphere(shared.get(positions), transform);
		});
		known.set(drawn, balls);
	}
	return balls;
}

/** Transforms a mesh's bounding sphere to an organ. */
function transformedSphere(
	ball: BoundingSphere | undefined,
	transform: DrawnSurface["transform"],
): BoundingSphere | undefined {
	if (!ball || !transform) return ball;
	const [x, y, z] = trianglesOf({ positions: Float32Array.of(ball.x, ball.y, ball.z), indices: [0], transform });
	// Enlarge the sphere: rounding must not leave a corner outside.
	return { x, y, z, radius: 1.0001 * Math.abs(transform[7]) * ball.radius + 1e-6 * Math.hypot(x, y, z) };
}

/** Returns a sphere about the mean of the corners (3 × corners) that contains all of them; not the smallest one. */
function ballAbout(corners: Float32Array): BoundingSphere | undefined {
	if (corners.length === 0) return undefined;
	let [x, y, z] = [0, 0, 0];
	for (let i = 0; i < corners.length; i += 3) {
		x += corners[i];
		y += corners[i + 1];
		z += corners[i + 2];
	}
	const count = corners.length / 3;
	[x, y, z] = [x / count, y / count, z / count];
	let radius = 0;
	for (let i = 0; i < corners.length; i += 3) {
		radius = Math.max(radius, Math.hypot(corners[i] - x, corners[i + 1] - y, corners[i + 2] - z));
	}
	return { x, y, z, radius };
}

type Direction = readonly [number, number, number];

/**
 * Returns whether a ray meets a sphere nearer than the nearest hit so far.
 * @param along unit direction of the ray
 */
function hitsSphere(ball: BoundingSphere, origin: ArrayLike<number>, along: Direction, nearest: number): boolean {
	const [x, y, z] = [ball.x - origin[0], ball.y - origin[1], ball.z - origin[2]];
	const middle = x * along[0] + y * along[1] + z * along[2];
	if (middle - ball.radius > nearest || middle + ball.radius < 0) return false;
	return x * x + y * y + z * z - middle * middle <= ball.radius * ball.radius;
}

/**
 * Returns the distance of the first triangle that is nearer than the nearest hit so far; undefined where there is none.
 */
function hitTriangles(
	corners: Float32Array,
	origin: ArrayLike<number>,
	along: Direction,
	nearest: number,
): number | undefined {
	let best: number | undefined;
	for (let i = 0; i < corners.length; i += 9) {
		const at = hitTriangle(corners, i, origin, along);
		if (at !== undefined && at < (best ?? nearest)) best = at;
	}
	return best;
}

/**
 * Returns the distance along a ray of its intersection with a triangle, from either side (Möller and Trumbore 1997);
 * undefined if they do not meet.
 * @param c corners, nine numbers per triangle
 * @param i index of the triangle's first number
 * @param o origin of the ray
 * @param d unit direction of the ray
 */
function hitTriangle(c: Float32Array, i: number, o: ArrayLike<number>, d: Direction): number | undefined {
	const [ax, ay, az] = [c[i + 3] - c[i], c[i + 4] - c[i + 1], c[i + 5] - c[i + 2]];
	const [bx, by, bz] = [c[i + 6] - c[i], c[i + 7] - c[i + 1], c[i + 8] - c[i + 2]];
	const [px, py, pz] = [d[1] * bz - d[2] * by, d[2] * bx - d[0] * bz, d[0] * by - d[1] * bx];
	const det = ax * px + ay * py + az * pz;
	if (det === 0) return undefined;
	const [tx, ty, tz] = [o[0] - c[i], o[1] - c[i + 1], o[2] - c[i + 2]];
	const u = (tx * px + ty * py + tz * pz) / det;
	const [qx, qy, qz] = [ty * az - tz * ay, tz * ax - tx * az, tx * ay - ty * ax];
	const v = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
	if (!(u >= 0 && v >= 0 && u + v <= 1)) return undefined;
	const at = (bx * qx + by * qy + bz * qz) / det;
	return at > 0 ? at : undefined;
}

/**
 * Returns the distance along the ray of the point nearest to a segment, where that is within its radius and the slack.
 */
function hitSegment(
	{ ends, radii }: DrawnGeometry,
	segment: number,
	origin: ArrayLike<number>,
	d: Direction,
	slack: number,
): number | undefined {
	const i = 6 * segment;
	const [wx, wy, wz] = [ends[i] - origin[0], ends[i + 1] - origin[1], ends[i + 2] - origin[2]];
	const [sx, sy, sz] = [ends[i + 3] - ends[i], ends[i + 4] - ends[i + 1], ends[i + 5] - ends[i + 2]];
	const ss = sx * sx + sy * sy + sz * sz;
	const sd = sx * d[0] + sy * d[1] + sz * d[2];
	const sw = sx * wx + sy * wy + sz * wz;
	const dw = d[0] * wx + d[1] * wy + d[2] * wz;
	const across = ss - sd * sd;
	const share = across > 1e-12 * ss ? Math.min(1, Math.max(0, (sd * dw - sw) / across)) : 0;
	const at = dw + share * sd;
	if (!(at > 0)) return undefined;
	const missed = Math.hypot(wx + share * sx - at * d[0], wy + share * sy - at * d[1], wz + share * sz - at * d[2]);
	const radius = radii[2 * segment] + share * (radii[2 * segment + 1] - radii[2 * segment]);
	return missed <= radius + slack * at ? at - Math.min(radius, at) : undefined;
}
