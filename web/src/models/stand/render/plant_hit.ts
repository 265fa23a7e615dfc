/** Finds the first plant of a stand that a ray hits; crowns are approximated by upright ellipsoids. */
import type { ViewRay } from "../../../render/model_renderer";
import type { StandPlant } from "../stand_plant";

/** Factor of the ellipsoid's radius: some twigs reach beyond the visible crown. */
const LEANER = 0.8;

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
		const out = Math.max(LEANER * scale * extent.out, 1e-6);
		const half = Math.max(0.5 * scale * (extent.high - extent.low), 1e-6);
		const middle = places.at[3 * plant + 1] + 0.5 * scale * (extent.high + extent.low);
		const from = [
			(origin[0] - places.at[3 * plant]) / out,
			(origin[1] - middle) / half,
			(origin[2] - places.at[3 * plant + 2]) / out,
		];
		const way = [direction[0] / out, direction[1] / half, direction[2] / out];
		const distance = unitSphereHit(from, way);
		if (distance >= nearest) continue;
		nearest = distance;
		found = plant;
	}
	return found;
}

/**
 * Distance to the unit sphere around the origin, in multiples of `way`; infinite where the sphere is missed or behind.
 */
function unitSphereHit(from: readonly number[], way: readonly number[]): number {
	const dot = (a: readonly number[], b: readonly number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
	const [a, b, c] = [dot(way, way), dot(from, way), dot(from, from) - 1];
	const square = b * b - a * c;
	if (square < 0) return Number.POSITIVE_INFINITY;
	const distance = (-b - Math.sqrt(square)) / a;
	return distance > 0 ? distance : Number.POSITIVE_INFINITY;
}
