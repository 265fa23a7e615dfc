/**
 * What the skin itself is like at a point, without light. `at` is the point in ball space (the berry scaled to the unit
 * ball), `chart` its u and v, `axis` towards the tip.
 */
export const SKIN_CHUNK = /* glsl */ `
uniform float uneven;
uniform float lenticels;
uniform float rows;
uniform float relief;
uniform float veins;

// How far the colour has turned here: it starts at the tip and in patches, and runs over the berry unevenly.
float turned_at(float turned, float along, float coarse, float fine) {
	float width = 0.35 + 0.5 * uneven;
	float late = 0.5 - 0.32 * along + 0.75 * uneven * (coarse - 0.5) + 0.3 * uneven * (fine - 0.5);
	return smoothstep(0.0, 1.0, (turned * (1.0 + width) - clamp(late, 0.0, 1.0)) / width);
}

// The normal of a rind with low bumps: uphill is where the noise grows.
vec3 rough(vec3 n, vec3 at, float height) {
	vec3 slope = vec3(0.0);
	for (int i = 0; i < 4; i++) {
		vec3 step = 0.3 * vec3(i == 1, i == 2, i == 3);
		slope += noise(at + step) * (i == 0 ? vec3(-1.0) : vec3(i == 1, i == 2, i == 3));
	}
	return normalize(n - height * (slope - n * dot(n, slope)));
}

// Drupelets or tubercles in staggered rows: tilts the normal, gives the height, 1 on top and 0 between them.
float humps(inout vec3 n, vec2 chart, vec3 axis) {
	float row = floor(chart.y * rows);
	float round_ = max(3.0, floor(2.0 * rows * sin(3.14159 * (row + 0.5) / rows)));
	vec2 cell = 2.0 * fract(vec2(chart.x * round_ + 0.5 * mod(row, 2.0), chart.y * rows)) - 1.0;
	float away = min(1.0, dot(cell, cell));
	vec3 north = normalize(axis - n * dot(axis, n) + 1e-5);
	n = normalize(n + relief * away * (cell.x * cross(n, north) + cell.y * north));
	return 1.0 - away * away;
}

// Small corky dots; too small to see, they fade.
float lenticel(vec3 at, float phase) {
	vec3 place = at * 11.0 + phase * 37.0;
	ivec3 cell = ivec3(floor(place));
	vec3 jitter = 0.5 + 0.24 * vec3(hash(cell) - 0.5, hash(cell + 71) - 0.5, hash(cell + 137) - 0.5);
	float there = step(0.45, hash(cell + 211));
	float pixel = length(fwidth(at)) * 11.0;
	float size = 0.1 + 0.08 * hash(cell + 17);
	float away = length(fract(place) - jitter);
	return there * (1.0 - smoothstep(size - 0.5 * pixel, size + 0.5 * pixel + 0.05, away)) * clamp(0.5 / pixel, 0.0, 1.0);
}

// Veins that run from the seat to the tip just under the skin.
float vein(vec2 chart, float fine) {
	float at = abs(fract(chart.x * 12.0 + 0.35 * (fine - 0.5)) - 0.5);
	return (1.0 - smoothstep(0.03, 0.16, at)) * smoothstep(0.04, 0.2, chart.y) * smoothstep(0.99, 0.85, chart.y);
}
`;
