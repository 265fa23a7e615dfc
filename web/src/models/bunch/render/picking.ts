import type { SceneVector, ViewRay } from "../../../render/model_renderer";
import type { Berries } from "../bunch_plant";
import { halvesOf } from "../traits";

/**
 * Returns the index of the nearest berry along a ray; undefined if there is none. Berries are treated as ellipsoids of
 * their width and length about their direction, as before contacts flatten them.
 */
export function pickBerry(berries: Berries, ray: ViewRay): number | undefined {
	let nearest: number | undefined;
	let nearestDistance = Infinity;
	for (let i = 0; i < berries.count; i++) {
		const distance = distanceToBerry(berries, i, ray);
		if (distance !== undefined && distance < nearestDistance) [nearest, nearestDistance] = [i, distance];
	}
	return nearest;
}

/**
 * Returns the distance along a ray, in lengths of its direction, to berry `i`; undefined where the ray misses it. The
 * ray is transformed so that the berry becomes the unit sphere.
 */
function distanceToBerry(berries: Berries, i: number, { origin, direction }: ViewRay): number | undefined {
	const { spheres, directions } = berries;
	const [width, length] = halvesOf(berries, i);
	const axis: SceneVector = [directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]];
	const from: SceneVector = [
		origin[0] - spheres[4 * i],
		origin[1] - spheres[4 * i + 1],
		origin[2] - spheres[4 * i + 2],
	];
	// In the space where the berry is the unit ball: lengths along the axis shrink by more than those across it.
	const shrink = width / length - 1;
	const scaled = (v: SceneVector) => v.map((value, k) => (value + dot(v, axis) * shrink * axis[k]) / width);
	const [p, d] = [scaled(from) as unknown as SceneVector, scaled(direction) as unknown as SceneVector];
	const a = dot(d, d);
	const b = dot(p, d);
	const discriminant = b * b - a * (dot(p, p) - 1);
	if (!(discriminant >= 0)) return undefined;
	const nearest = (-b - Math.sqrt(discriminant)) / a;
	return nearest > 0 ? nearest : undefined;
}

/** Returns the dot product of two vectors. */
function dot(a: SceneVector, b: SceneVector): number {
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
