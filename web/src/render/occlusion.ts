/**
 * Share of a lamp's light that spheres hide from a point; the same formula as in the bunch's lamp_shader.ts, evaluated
 * once for a whole body.
 */

/**
 * Returns the share of a round area light that a sphere hides.
 * @param lateral distance of the sphere's centre from the ray towards the light's centre
 * @param along distance to the sphere along that ray; a sphere behind the point hides nothing
 * @param spread tangent of the light's apparent radius
 */
export function lampHidden(radius: number, lateral: number, along: number, spread: number): number {
	if (along <= 0) return 0;
	const blur = Math.max(along * spread, 1e-9);
	const most = Math.min(1, (radius / blur) ** 2);
	const t = Math.min(1, Math.max(0, (lateral - radius + blur) / (2 * blur)));
	return most * (1 - t * t * (3 - 2 * t));
}
