/**
 * How much light spheres take from a point: the formulae that light_shader.ts also evaluates per pixel. Here they
 * serve what is settled once for a whole body, and the tests.
 */

/**
 * Share of the sky's light (weighted by the cosine to the normal) that one sphere hides from a point outside it.
 * Exact while the sphere is wholly above the horizon, sin²α · cos γ; below, a parabola that meets it smoothly and
 * reaches 0 as the sphere sets.
 * @param sine r/d, the sine of the sphere's apparent radius α
 * @param cosine of the angle γ between normal and sphere
 */
export function skyHidden(sine: number, cosine: number): number {
	if (cosine <= -sine) return 0;
	const lifted = cosine >= sine ? cosine : (cosine + sine) ** 2 / (4 * sine);
	return sine * sine * lifted;
}

/**
 * Share of a round area light that a sphere hides.
 * @param lateral distance of the sphere's centre from the ray towards the light's centre
 * @param along distance to the sphere along that ray; behind the point nothing is hidden
 * @param spread tangent of the light's apparent radius
 */
export function lampHidden(radius: number, lateral: number, along: number, spread: number): number {
	if (along <= 0) return 0;
	const blur = Math.max(along * spread, 1e-9);
	const most = Math.min(1, (radius / blur) ** 2);
	const t = Math.min(1, Math.max(0, (lateral - radius + blur) / (2 * blur)));
	return most * (1 - t * t * (3 - 2 * t));
}
