/**
 * Light that has been inside a berry. All vectors are in ball space, where the berry is the unit ball about the origin, so
 * that paths have formulae; lengths are in its radii.
 */
export const FLESH_CHUNK = /* glsl */ `
// Length of the way from a point in the ball to its surface.
float way_out(vec3 at, vec3 towards) {
	float b = dot(at, towards);
	return sqrt(max(0.0, b * b + 1.0 - dot(at, at))) - b;
}

// Light of both lamps scattered once on the line of sight, which enters at \`at\` and runs along \`inward\`: at each of
// three points, what is left of the lamp's light on its way in and of the scattered light on its way out.
vec3 scattered(vec3 at, vec3 inward, float run, vec3 absorption, vec3 keyward, vec3 keyLight, vec3 rimward, vec3 rimLight) {
	vec3 sum = vec3(0.0);
	for (int i = 0; i < 3; i++) {
		float gone = run * (0.12 + 0.36 * float(i));
		vec3 p = at + gone * inward;
		sum += keyLight * exp(-absorption * (gone + way_out(p, keyward)));
		sum += rimLight * exp(-absorption * (gone + way_out(p, rimward)));
	}
	return sum * (0.34 * run);
}

// How much of the light on the line of sight the seeds take. They stand round the axis, pointed towards the seat; the
// flesh blurs them the more the deeper they lie.
float seed_shade(vec3 at, vec3 inward, vec3 axis, float seeds, float phase, float slender) {
	vec3 east = normalize(cross(axis, vec3(0.31, 0.17, 0.93)));
	vec3 north = cross(axis, east);
	float shade = 0.0;
	int count = int(seeds + 0.5);
	for (int k = 0; k < count; k++) {
		float turn = 6.2831853 * (phase + float(k) / seeds);
		vec3 centre = 0.27 * (cos(turn) * east + sin(turn) * north) - (0.12 + 0.08 * sin(9.0 * turn)) * axis;
		vec3 from = at - centre;
		// Into the space where the seed is a unit ball; towards the seat it is drawn to a point.
		float taper = 0.16 * (1.0 + 0.35 * dot(from, axis));
		vec3 stretch = axis * (taper / (0.36 * slender) - 1.0);
		vec3 a = (from + stretch * dot(from, axis)) / taper;
		vec3 b = (inward + stretch * dot(inward, axis)) / taper;
		float nearest = max(0.0, -dot(a, b) / dot(b, b));
		vec3 miss = a + nearest * b;
		float soft = 0.35 + 0.5 * nearest;
		shade = max(shade, (1.0 - smoothstep(1.0 - soft, 1.0 + soft, length(miss))) * exp(-0.7 * nearest));
	}
	return shade;
}
`;
