/** A convex body around the trunk, for collisions in games. */
import type { PartMesh, Vector } from "../../plant/part";
import type { Skeleton } from "../cards/skeleton";
import { add, between, dot, lengthOf, scaled, subtract } from "../cards/vectors";

const SIDES = 8;
/** The hull ends at this share of the tree's height, or where the trunk ends. */
const SHARE = 0.35;

export interface TrunkHull {
	readonly mesh: PartMesh;
	/** The same as a cone without its tip: both ends of the axis, and radii that hold the trunk. */
	readonly start: Vector;
	readonly end: Vector;
	readonly radii: readonly [start: number, end: number];
}

/** Returns the hull of the thickest trunk: a prism of eight sides, narrower at the top. */
export function trunkHull(skeleton: Skeleton): TrunkHull {
	const trunks = skeleton.stems.filter(({ order }) => order === 0);
	const trunk = trunks.reduce((best, each) => (each.radius > best.radius ? each : best));
	const line = skeleton.line(trunk, 0);
	const top = line[0].place[1] + SHARE * skeleton.height;
	const last = line.findIndex(({ place }) => place[1] >= top);
	const points = line.slice(0, last < 1 ? line.length : last + 1);
	const start = points[0].place;
	const end = points.length > 1 ? points[points.length - 1].place : add(start, [0, 0.01, 0]);
	const axis = subtract(end, start);
	const length = lengthOf(axis);
	const ends: [number, number] = [points[0].radius, points[points.length - 1].radius];
	// Both ends grow until every ring of the trunk is inside the flat sides.
	let more = 0;
	for (const { place, radius } of points) {
		const share = Math.min(1, Math.max(0, dot(subtract(place, start), axis) / (length * length)));
		const off = lengthOf(subtract(place, between(start, end, share)));
		more = Math.max(more, (off + radius) / Math.cos(Math.PI / SIDES) - (ends[0] + share * (ends[1] - ends[0])));
	}
	const radii = [ends[0] + more, ends[1] + more] as const;
	const ring = (centre: Vector, radius: number) =>
		Array.from({ length: SIDES }, (_, k): Vector => {
			const angle = (2 * Math.PI * k) / SIDES;
			return add(centre, [radius * Math.cos(angle), 0, -radius * Math.sin(angle)]);
		});
	const corners = [...ring(start, radii[0]), ...ring(end, radii[1])];
	const middle = scaled(add(start, end), 0.5);
	const indices: number[] = [];
	for (let k = 0; k < SIDES; k++) {
		const next = (k + 1) % SIDES;
		indices.push(k, next, SIDES + next, k, SIDES + next, SIDES + k);
		if (k > 0 && k < SIDES - 1) indices.push(0, k + 1, k, SIDES, SIDES + k, SIDES + k + 1);
	}
	const normals = corners.flatMap((corner) => {
		const away = subtract(corner, middle);
		return scaled(away, 1 / lengthOf(away));
	});
	const mesh = {
		positions: Float32Array.from(corners.flat()),
		normals: Float32Array.from(normals),
		uvs: new Float32Array(0),
		indices: Uint32Array.from(indices),
	};
	return { mesh, start, end, radii };
}
