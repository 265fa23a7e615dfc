/**
 * Leaf veins, finer than vertices: five main ones fan out from the petiole at (1/2, 0.16) of the chart at 0°, 52° and 108°
 * from the midrib (models/bunch/foliage/leaf.hpp); side veins leave them in pairs. They
 * stay green longest.
 */
export const LEAF_CHUNK = /* glsl */ `
float veins(vec2 at) {
	vec2 from = vec2(abs(at.x - 0.5), at.y - 0.16);
	float away = length(from);
	float angle = atan(from.x, from.y);
	float nearest = angle < 0.46 ? 0.0 : angle < 1.4 ? 0.91 : 1.88;
	float off = (angle - nearest) * away;
	float main_ = 1.0 - smoothstep(0.004, 0.012 + 0.006 * (1.0 - away), abs(off));
	float run = away * 9.0 - abs(off) * 8.0;
	float side = 1.0 - smoothstep(0.03, 0.13, abs(fract(run) - 0.5));
	return max(main_, 0.45 * side * smoothstep(0.0, 0.05, abs(off)));
}
vec3 detailed(vec3 colour, vec2 chart) {
	return mix(colour, vec3(0.18, 0.23, 0.067), 0.55 * veins(chart));
}
`;
