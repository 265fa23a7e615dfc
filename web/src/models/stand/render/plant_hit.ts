/** Finds the first plant of a stand that a ray hits; crowns are approximated by upright ellipsoids. */
import type { ViewRay } from "../../../render/model_renderer";
import type { StandPlant } from "../stand_plant";

/** Factor of the ellipsoid's radius: some twigs reach beyond the visible crown. */
const RADIUS_FACTOR = 0.8;

/** Returns the plant whose extent a ray meets first; undefined if it meets none. */
export function firstPlantHit(
	{ places, memberOf, members }: Pick<StandPlant, "places" | "memberOf" | "members">,
	{ origin, direction }: ViewRay,
): number | undefined {
	let nearest = Number.POSITIVE_INFINITY;
	let found: number | undefined;
	for (let plant = 0; plant < places.count; plant++) {
		const extent = members[memberOf[plant]]?.extent;
		if (!extent) continue;
		const scale = places.scale[plant];
		const radius = Math.max(RADIUS_FACTOR * scale * extent.out, 1e-6);
		const halfHeight = Math.max(0.5 * scale * (extent.high - extent.low), 1e-6);
		const middle = places.at[3 * plant + 1] + 0.5 * scale * (extent.high + extent.low);
		const from = [
			(origin[0] - places.at[3 * plant]) / radius,
			(origin[1] - middle) / halfHeight,
			(origin[2] - places.at[3 * plant + 2]) / radius,
		];
		const scaledDirection = [direction[0] / radius, direction[1] / halfHeight, direction[2] / radius];
		const distance = unitSphereHit(from, scaledDirection);
		if (distance >= nearest) continue;
		nearest = distance;
		found = plant;
	}
	return found;
}

/**
 * Returns the distance from a point to the unit sphere around the origin along a direction, in lengths of the direction
 * (the smaller root of a quadratic equation); infinite where the sphere is missed or behind.
 */
function unitSphereHit(from: readonly number[], direction: readonly number[]): number {
	const dot = (a: readonly number[], b: readonly number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
	const [a, b, c] = [dot(direction, direction), dot(from, direction), dot(from, from) - 1];
	const discriminant = b * b - a * c;
	if (discriminant < 0) return Number.POSITIVE_INFINITY;
	const distance = (-b - Math.sqrt(discriminant)) / a;
	return distance > 0 ? distance : Number.POSITIVE_INFINITY;
}
