/** What of a plant a line of sight meets first: a segment or an organ. */
import { type Drawn, trianglesOf } from "./drawn";

/** A line of sight, in metres. */
export interface Line {
	readonly origin: ArrayLike<number>;
	/** Of any length. */
	readonly direction: ArrayLike<number>;
}

/** What is met: one of the two. */
export interface Sighted {
	readonly segment?: number;
	readonly organ?: number;
}

/** Balls and triangles of organs, made when first asked for. */
interface Organ {
	readonly x: number;
	readonly y: number;
	readonly z: number;
	readonly radius: number;
	readonly corners: Float32Array;
}

const known = new WeakMap<Drawn, (Organ | undefined)[]>();

/**
 * What is met first.
 * @param slack by how much a segment may be missed, over its distance: threads are hard to hit
 */
export function sighted(drawn: Drawn, { origin, direction }: Line, slack: number): Sighted | undefined {
	const length = Math.hypot(direction[0], direction[1], direction[2]);
	const along = [direction[0] / length, direction[1] / length, direction[2] / length] as const;
	let [nearest, found] = [Number.POSITIVE_INFINITY, undefined as Sighted | undefined];
	organsOf(drawn).forEach((organ, index) => {
		const at = organ && meetsOrgan(organ, origin, along, nearest);
		if (at !== undefined) [nearest, found] = [at, { organ: index }];
	});
	for (let segment = 0; segment < drawn.radii.length / 2; segment++) {
		const at = meetsSegment(drawn, segment, origin, along, slack);
		if (at !== undefined && at < nearest) [nearest, found] = [at, { segment }];
	}
	return found;
}

function organsOf(drawn: Drawn): (Organ | undefined)[] {
	const organs =
		known.get(drawn) ??
		Array.from({ length: drawn.organs }, (_, index): Organ | undefined => {
			const surface = drawn.surface(index);
			return surface && ballAbout(trianglesOf(surface));
		});
	known.set(drawn, organs);
	return organs;
}

function ballAbout(corners: Float32Array): Organ | undefined {
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
	return { x, y, z, radius, corners };
}

type Direction = readonly [number, number, number];

/** How far the first of an organ's triangles is that is met; undefined where none is nearer than what is known. */
function meetsOrgan(organ: Organ, origin: ArrayLike<number>, along: Direction, nearest: number): number | undefined {
	const [x, y, z] = [organ.x - origin[0], organ.y - origin[1], organ.z - origin[2]];
	const middle = x * along[0] + y * along[1] + z * along[2];
	if (middle - organ.radius > nearest || middle + organ.radius < 0) return undefined;
	if (x * x + y * y + z * z - middle * middle > organ.radius * organ.radius) return undefined;
	let best: number | undefined;
	for (let i = 0; i < organ.corners.length; i += 9) {
		const at = meetsTriangle(organ.corners, i, origin, along);
		if (at !== undefined && at < (best ?? nearest)) best = at;
	}
	return best;
}

/** Möller and Trumbore (1997), from both sides. */
function meetsTriangle(c: Float32Array, i: number, o: ArrayLike<number>, d: Direction): number | undefined {
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

/** How far along the line a segment is nearest to it, where that is within its radius and the slack. */
function meetsSegment(
	{ ends, radii }: Drawn,
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
